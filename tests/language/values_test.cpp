#include "language/language.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>

#include "certified.hpp"
#include "language/detail/judge.hpp"
#include "notation/notation.hpp"
#include "oracle/language_words.hpp"

using namespace algae;

namespace {

template <typename Form>
random::Certified decided(const Form& says, const random::Languages& made) {
    random::Certified found = random::sound(random::claim_of({says}, made.systems));
    RC_TAG(found.rule() + ": " +
           (found.rule().empty() ? "undecided" : verify::to_string(found.finding.outcome)));
    return found;
}

}  // namespace

TEST_CASE("what is found to be finite has the words of the definitions, and no other size") {
    CHECK(rc::check([] {
        const random::Languages made = *random::any_language();
        const random::Certified finite = decided(IsFinite{made.all.front()}, made);
        const auto value = finite_value(made.all.front(), *random::letters());
        if (value) RC_ASSERT(finite.judgement.truth == Truth::proved);
        if (finite.judgement.truth == Truth::refuted) {
            RC_ASSERT(!value.has_value());
            RC_ASSERT(decided(HasSize{made.all.front(), Integer(3)}, made).judgement.truth !=
                      Truth::proved);
            return;
        }
        if (!value) return;
        for (const std::size_t longest : {5u, 3u}) {
            const auto words = oracle::language_words(made.all.front(), longest);
            if (!words) continue;
            std::set<Word> same;
            for (const Word& word : value->words)
                if (word.size() <= longest) same.insert(word);
            RC_ASSERT(same == *words);
            break;
        }
        const Integer size(static_cast<long>(value->words.size()));
        RC_ASSERT(decided(HasSize{made.all.front(), size}, made).judgement.truth == Truth::proved);
        RC_ASSERT(decided(HasSize{made.all.front(), size + Integer(1)}, made).judgement.truth ==
                  Truth::refuted);
    }));
}

TEST_CASE("a language is found empty only if it has no short word") {
    CHECK(rc::check([] {
        const random::Languages made = *random::any_language();
        const random::Certified empty = decided(IsEmpty{made.all.front()}, made);
        const auto words = oracle::language_words(made.all.front(), 4);
        if (!words) return;
        if (empty.judgement.truth == Truth::proved) RC_ASSERT(words->empty());
        if (!words->empty()) RC_ASSERT(empty.judgement.truth == Truth::refuted);
    }));
}

TEST_CASE("what L(G) and a regular language have in common is found empty or has a word") {
    CHECK(rc::check([] {
        const random::Languages made = *rc::gen::resize(
            100, rc::gen::exec([] {
                random::Maker make({});
                Language regular = combined(LanguageTree::Kind::star, {make.words()});
                if (*rc::gen::arbitrary<bool>()) regular = complement_language(regular, {0, 1});
                return make.made({combined(LanguageTree::Kind::intersected,
                                           {generated_language(make.system()), regular})});
            }));
        const random::Certified empty = decided(IsEmpty{made.all.front()}, made);
        RC_ASSERT(empty.judgement.truth != Truth::undecided);
        const auto words = oracle::language_words(made.all.front(), 5);
        RC_PRE(words.has_value());
        if (empty.judgement.truth == Truth::proved) RC_ASSERT(words->empty());
    }));
}

TEST_CASE("a language behind an empty one is empty, even if it is that of a system with contexts") {
    const Claim claim = read_claim(
        "claim T\nlet G = IL { axiom a; a < b -> a; a -> ab; b -> b }\n"
        "show ({a} & {b}) L(G) is empty\nshow ({a} & {b}) L(G) is finite",
        "t.claim", {});
    for (const CheckedStatement& found : check(claim).statements)
        CHECK(found.answer.truth == Truth::proved);
}
