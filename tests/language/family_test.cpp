#include "language/language.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>

#include "certified.hpp"
#include "oracle/finite_systems.hpp"

using namespace algae;

namespace {

struct Form {
    const char* name;
    bool propagating, deterministic, tables;
};
constexpr Form forms[] = {{"0L", false, false, false}, {"P0L", true, false, false},
                          {"D0L", false, true, false}, {"PD0L", true, true, false},
                          {"T0L", false, false, true}, {"PT0L", true, false, true},
                          {"DT0L", false, true, true}, {"PDT0L", true, true, true}};

Language language_of(const std::vector<std::string>& words) {
    std::vector<Word> all;
    for (const std::string& text : words) all.push_back(random::word_of(text));
    return words_language(std::move(all));
}

Claim is(const std::string& family, const Language& language,
         std::vector<std::shared_ptr<const SourceSystem>> systems = {}) {
    return random::claim_of({InFamily{language, family}}, std::move(systems));
}

/// Every finite language over so many letters of words of at most `longest` letters, for each family: the
/// verdict against all systems written down, the proof against verify.
void decide_all(int letters, std::size_t longest, unsigned every) {
    const std::vector<std::string> words = oracle::FiniteSystems::words(letters, longest);
    for (const Form& form : forms) {
        const oracle::FiniteSystems systems(letters, longest, form.propagating, form.deterministic);
        const std::set<std::uint64_t> generated =
            form.tables ? systems.with_tables() : systems.without_tables();
        for (std::uint64_t language = 1; language < std::uint64_t{1} << words.size();
             language += every) {
            CAPTURE(form.name);
            CAPTURE(language);
            const random::Certified found =
                random::certified(is(form.name, language_of(oracle::words_of(words, language))));
            CHECK((found.judgement.truth == Truth::proved) == generated.contains(language));
            CHECK(found.judgement.truth != Truth::undecided);
            CHECK_MESSAGE(found.is_checked(), found.finding.reason);
        }
    }
}

}  // namespace

TEST_CASE("finite languages over one letter are of the families whose systems generate them") {
    decide_all(1, 4, 1);
}

TEST_CASE("finite languages over two letters are of the families whose systems generate them") {
    decide_all(2, 2, 1);
}

TEST_CASE("verdicts on families of random expressions have proofs that hold") {
    CHECK(rc::check([] {
        random::Languages made = *random::any_language({1});
        const std::string family = *rc::gen::elementOf(
            std::vector<std::string>{"0L", "P0L", "D0L", "PD0L", "T0L", "PT0L", "DT0L", "PDT0L",
                                     "E0L", "ET0L", "EDT0L", "IL", "REG", "CF"});
        const random::Certified found = random::sound(is(family, made.all.front(), made.systems));
        RC_TAG(found.rule() + ": " +
               (found.rule().empty() ? "undecided" : verify::to_string(found.finding.outcome)));
    }));
}

TEST_CASE("a language given by a system is of every family that has its form") {
    CHECK(rc::check([] {
        const random::Languages made =
            *rc::gen::resize(100, rc::gen::exec([] {
                                 random::Maker make({});
                                 return make.made({generated_language(make.system())});
                             }));
        std::string family = family_name(*made.systems.front()->tables);
        if (family.starts_with("E"))
            family = family.find('T') == std::string::npos ? "E0L" : "ET0L";
        const random::Certified found = random::sound(is(family, made.all.front(), made.systems));
        RC_ASSERT(found.judgement.truth == Truth::proved);
        RC_ASSERT(random::sound(is("ET0L", made.all.front(), made.systems)).judgement.truth ==
                  Truth::proved);
    }));
}
