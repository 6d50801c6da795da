// Finite languages as proofs by cases have them, and what is too long for such a proof.

#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "verify/samples.hpp"
#include "verify/verify.hpp"

using namespace algae;

TEST_CASE("a family is found by its name, and no other name is one") {
    CHECK(all_families().size() == 8);
    for (const Family family : all_families()) CHECK(family_named(to_string(family)) == family);
    CHECK(family_named("0L") == Family{});
    CHECK(family_named("PDT0L") == Family{true, true, true});
    CHECK(to_string(Family{true, false, false}) == "P0L");
    CHECK(to_string(Family{false, true, false}) == "D0L");
    CHECK(to_string(Family{false, false, true}) == "T0L");
    CHECK_THROWS_WITH_AS(family_named("E0L"),
                         "expected one of the families 0L, P0L, D0L, PD0L, T0L, PT0L, DT0L and "
                         "PDT0L, found 'E0L'",
                         Error);
}

TEST_CASE("a finite language has its words in order, each once, and its letters") {
    const FiniteLanguage language = finite_language({"ca", "b", "", "b", "aa"});
    CHECK(to_string(language) == "{ε, b, aa, ca}");
    CHECK(to_string(finite_language({"a"})) == "{a}");
    CHECK(to_string(finite_language({})) == "{}");
    CHECK(letters_of(language) == std::vector<Symbol>{0, 1, 2});
    CHECK(language.contains({}));
    CHECK(language.contains({2, 0}));
    CHECK(!language.contains({0, 2}));
    CHECK(letters_of(finite_language({"b"})) == std::vector<Symbol>{0});
    CHECK(certificate_text(*language.alphabet, {2, 0, 1}) == "c a b");
    CHECK(certificate_text(*language.alphabet, {}) == "");
}

TEST_CASE("a proof by cases about words of more than 2000 letters is not checked") {
    const auto found = [](std::size_t letters) {
        std::string word = "a";
        for (std::size_t i = 1; i < letters; ++i) word += " a";
        const samples::Json statement{{"is", "0L"}, {"language", {{"words", {word}}}}};
        const samples::Json proof{{"by", "cases"},
                                  {"obstruction",
                                   {{"root",
                                     {{"excluded", samples::Json::array()},
                                      {"end", "sources"},
                                      {"sources", samples::Json::array()}}}}}};
        Budget budget = samples::small_budget();
        budget.deadline.reset();  // a slow machine says the same
        return samples::check(samples::certificate(statement, "refuted", proof), budget)[0];
    };
    const verify::Finding longer = found(2001);
    CHECK(longer.outcome == verify::Finding::Outcome::not_checked);
    CHECK(longer.reason == "a proof by cases with words of more than 2000 letters is not checked");
    const verify::Finding longest = found(2000);
    CHECK(longest.outcome == verify::Finding::Outcome::not_checked);
    CHECK_MESSAGE(longest.reason.find("the factors of the words") != std::string::npos,
                  longest.reason);
}
