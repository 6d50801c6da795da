#include "language/detail/letters.hpp"
#include "language/detail/regular.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exact/exact.hpp"
#include "language/regular_any.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

namespace {

Word word_of(const OL& system, const std::string& text) {
    Word word;
    for (const char letter : text)
        word.push_back(system.alphabet->find(std::string(1, letter)).value());
    return word;
}

/// All words with this factor, or all without it.
RegularLanguage with(const Word& factor) {
    return concatenated(concatenated(all_words({0, 1}), finite_set({factor})), all_words({0, 1}));
}
RegularLanguage without(const Word& factor) { return complement(with(factor), {0, 1}); }

}  // namespace

TEST_CASE("a first meeting is where trying every choice finds it, with a shortest word") {
    for (const bool erasing : {false, true}) {
        const bool holds = rc::check("0L systems and regular languages", [=] {
            const auto written = *oracle::any_0l(2, erasing);
            const OL system = oracle::ol_of(written);
            const RegularLanguage language = regular_tests::any_listed(2).language;
            const Meeting found = first_meeting(system, language);
            if (found.derivation) {
                RC_ASSERT(is_derivation(system, *found.derivation));
                RC_ASSERT(found.derivation->choices.size() == found.step);
                RC_ASSERT(language.contains(found.derivation->words.back()));
            }
            for (unsigned n = 0; n <= 3; ++n) {
                const auto words = oracle::words_of_generation(written, n);
                if (words.size() > 300) break;
                std::optional<std::size_t> shortest;
                for (const std::string& text : words)
                    if (language.contains(word_of(system, text)))
                        shortest = std::min(shortest.value_or(text.size()), text.size());
                if (!shortest) RC_ASSERT(!found.derivation || found.step > n);
                if (shortest) {
                    RC_ASSERT(found.derivation.has_value());
                    RC_ASSERT(found.step == n);
                    RC_ASSERT(found.derivation->words.back().size() == *shortest);
                    break;
                }
            }
        });
        CHECK(holds);
    }
}

TEST_CASE("one word is met exactly if it is a member") {
    const bool holds = rc::check("members", [] {
        const auto written = *oracle::any_0l(3, true);
        const OL system = oracle::ol_of(written);
        const Word word = word_of(system, *oracle::any_word(written.axiom, 4));
        const Membership member = membership(system, word);
        const Meeting meeting = first_meeting(system, finite_set({word}));
        RC_ASSERT(member.member == meeting.derivation.has_value());
        if (member.member) RC_ASSERT(member.step == meeting.step);
    });
    CHECK(holds);
}

TEST_CASE("what Fibonacci words never have") {
    const OL fibonacci = ol("b", {{'b', "a"}, {'a', "ab"}});  // b is letter 0
    REQUIRE(fibonacci.alphabet->name(0) == "b");
    CHECK_FALSE(first_outside(fibonacci, without({0, 0})).derivation);
    CHECK_FALSE(first_outside(fibonacci, without({1, 1, 1})).derivation);
    CHECK_FALSE(first_meeting(fibonacci, with({0, 1, 0, 1, 0})).derivation.has_value());
    const Meeting squares = first_meeting(fibonacci, with({1, 1}));
    REQUIRE(squares.derivation);
    CHECK(squares.step == 4);
    CHECK(spell(*fibonacci.alphabet, squares.derivation->words.back()) == "abaab");
}

TEST_CASE("inclusion both ways where the language is finite or fills a regular one") {
    const OL all = ol("a", {{'a', "a"}, {'a', "aa"}});
    CHECK_FALSE(first_outside(all, plus(finite_set({{0}}))).derivation);
    const Meeting even = first_outside(all, plus(finite_set({{0, 0}})));
    REQUIRE(even.derivation);
    CHECK(even.step == 0);
    const OL powers = ol("a", {{'a', "aa"}});
    const Meeting long_word =
        first_meeting(powers, concatenated(finite_set({Word(100, 0)}), all_words({0})));
    REQUIRE(long_word.derivation);
    CHECK(long_word.derivation->words.back().size() == 128);
    CHECK_FALSE(first_meeting(powers, plus(finite_set({{0, 0, 0}}))).derivation);
    CHECK_FALSE(first_meeting(powers, RegularLanguage()).derivation);
}

TEST_CASE("letters that must die do so at once, so a late meeting has short words") {
    // A takes 25 steps to become Z; meanwhile each a could double.
    std::vector<std::pair<char, std::string>> rules{{'a', "aa"}, {'a', "a"}, {'a', ""}};
    const std::string chain = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        rules.emplace_back(chain[i], std::string{chain[i + 1]});
    const OL system = ol("aA", rules);
    const Meeting found = first_meeting(system, finite_set({{*system.alphabet->find("Z")}}));
    REQUIRE(found.derivation);
    CHECK(found.step == 25);
    CHECK(is_derivation(system, *found.derivation));
    for (const Word& word : found.derivation->words) CHECK(word.size() <= 2);
}

TEST_CASE("a word too long to be written out is refused with its generation") {
    Budget budget;
    budget.letters = 1000;
    const OL powers = ol("a", {{'a', "aa"}});
    CHECK_THROWS_AS(
        first_meeting(powers, concatenated(finite_set({Word(1100, 0)}), all_words({0})), budget),
        BoundReached);
}
