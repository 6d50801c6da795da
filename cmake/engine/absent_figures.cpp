// What the engine of figures (tools/engine) has in place of what only the engine of the theory has: claims, languages, dimension, lessons,
// and what an editor asks. It is what a page loads first, so it has no more than a first picture and what belongs to it need.

#include "command/detail/verb.hpp"
#include "language/language.hpp"
#include "lesson/lesson.hpp"
#include "notation/notation.hpp"

namespace algae {

namespace {

[[noreturn]] void refuse(const char* what) {
    throw Error(std::string(what) + ": the engine of figures does not have it");
}

}  // namespace

std::span<const GalleryEntry> theory_claims() { return {}; }
std::vector<Lesson> lessons() { return {}; }

Claim read_claim(std::string_view, const std::string&, const SystemSource&,
                 const std::vector<std::string>&) {
    refuse("a claim");
}
Answer decide(const Statement&, const Claim&, const Budget&, const SearchLimits&) {
    refuse("a claim");
}
std::vector<std::string> sentences(const Answer&, const Alphabet&) { refuse("a claim"); }
Language generated_language(std::shared_ptr<const SourceSystem>) { refuse("a language"); }
ContextGrowth context_growth(const IL&, const Budget&) { refuse("growth with context"); }

}  // namespace algae

namespace algae::command {

void add_member(Verbs&) {}
void add_finite(Verbs&) {}
void add_equal(Verbs&) {}
void add_is(Verbs&) {}
void add_list(Verbs&) {}
void add_check(Verbs&) {}
void add_verify(Verbs&) {}
void add_lesson(Verbs&) {}
void add_lsp(Verbs&) {}
void add_dimension(Verbs&) {}

}  // namespace algae::command
