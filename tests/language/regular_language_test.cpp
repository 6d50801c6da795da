#include "language/detail/regular.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "exact/exact.hpp"
#include "language/regular_any.hpp"

using namespace algae;
using namespace algae::regular_tests;

namespace {

/// Two states of a minimal automaton differ on a word of fewer letters than there are states: found
/// by marking pairs (Moore 1956), no algorithm of the library.
bool no_two_states_are_equivalent(const Dfa& automaton) {
    const std::size_t n = automaton.states();
    std::vector<std::vector<char>> differ(n, std::vector<char>(n, 0));
    for (std::size_t s = 0; s < n; ++s)
        for (std::size_t t = 0; t < n; ++t)
            differ[s][t] = automaton.accepting[s] != automaton.accepting[t];
    for (std::size_t round = 0; round < n; ++round)
        for (std::size_t s = 0; s < n; ++s)
            for (std::size_t t = 0; t < n; ++t)
                for (Symbol a = 0; a < automaton.letters; ++a)
                    if (differ[automaton.step(s, a)][automaton.step(t, a)]) differ[s][t] = 1;
    for (std::size_t s = 0; s < n; ++s)
        for (std::size_t t = 0; t < s; ++t)
            if (!differ[s][t]) return false;
    return true;
}

/// An automaton with any transitions.
Dfa any_dfa() {
    const auto states = *rc::gen::inRange<std::size_t>(1, 9);
    const auto letters = *rc::gen::inRange<std::size_t>(1, 3);
    return {letters, *rc::gen::inRange<std::size_t>(0, states),
            *rc::gen::container<std::vector<char>>(states, rc::gen::element<char>(0, 1)),
            *rc::gen::container<std::vector<std::size_t>>(
                states * letters, rc::gen::inRange<std::size_t>(0, states))};
}

}  // namespace

TEST_CASE("every operation gives the words that listing them gives") {
    const bool holds = rc::check("operations", [] {
        const Listed left = any_listed(2), right = any_listed(2);
        RC_ASSERT(contained(left.language) == left.words);
        std::set<Word> both;
        std::set_intersection(left.words.begin(), left.words.end(), right.words.begin(),
                              right.words.end(), std::inserter(both, both.end()));
        RC_ASSERT(contained(intersected(left.language, right.language)) == both);
        std::set<Word> one;
        std::set_symmetric_difference(left.words.begin(), left.words.end(), right.words.begin(),
                                      right.words.end(), std::inserter(one, one.end()));
        RC_ASSERT(contained(symmetric_difference(left.language, right.language)) == one);
        std::set<Word> others = all_short_words();
        std::erase_if(others, [&](const Word& word) { return left.words.contains(word); });
        RC_ASSERT(contained(complement(left.language, {0, 1})) == others);
        std::set<Word> backwards;
        for (const Word& word : left.words) backwards.insert(Word(word.rbegin(), word.rend()));
        RC_ASSERT(contained(reversed(left.language)) == backwards);
    });
    CHECK(holds);
}

TEST_CASE("equal languages have equal automata, however they were made") {
    const bool holds = rc::check("laws", [] {
        const auto a = any_listed(2).language, b = any_listed(2).language,
                   c = any_listed(1).language;
        RC_ASSERT(united(a, b) == united(b, a));
        RC_ASSERT(reversed(reversed(a)) == a);
        RC_ASSERT(reversed(concatenated(a, b)) == concatenated(reversed(b), reversed(a)));
        RC_ASSERT(concatenated(a, united(b, c)) == united(concatenated(a, b), concatenated(a, c)));
        RC_ASSERT(concatenated(concatenated(a, b), c) == concatenated(a, concatenated(b, c)));
        RC_ASSERT(star(star(a)) == star(a));
        RC_ASSERT(star(united(a, b)) == star(concatenated(star(a), star(b))));
        RC_ASSERT(complement(complement(a, {0, 1}), {0, 1}) == a);
        RC_ASSERT(difference(a, b) == intersected(a, complement(b, {0, 1})));
        RC_ASSERT(united(difference(a, b), intersected(a, b)) == a);
        RC_ASSERT(united(a, finite_set({{0, 5}})) != a);
        RC_ASSERT(difference(united(a, finite_set({{0, 5}})), finite_set({{0, 5}})) == a);
    });
    CHECK(holds);
}

TEST_CASE("a minimal automaton accepts the same words and no two of its states are equivalent") {
    const bool holds = rc::check("minimal", [] {
        const Dfa automaton = any_dfa();
        const Dfa found = minimal(automaton);
        RC_ASSERT(no_two_states_are_equivalent(found));
        RC_ASSERT(minimal(found) == found);
        RC_ASSERT(found.states() <= automaton.states());
        for (const Word& word : all_short_words())
            RC_ASSERT(found.accepts(word) == automaton.accepts(word));
        // Brzozowski 1963: backwards, made deterministic, and once more.
        const Dfa twice = determinised(reversed(as_nfa(determinised(reversed(as_nfa(automaton))))));
        RC_ASSERT(minimal(twice) == found);
        RC_ASSERT(RegularLanguage(as_nfa(automaton)) == RegularLanguage(automaton));
    });
    CHECK(holds);
}

TEST_CASE("the smallest languages") {
    const RegularLanguage none, empty_word = finite_set({{}});
    CHECK(none != empty_word);
    CHECK(star(none) == empty_word);
    CHECK(plus(none) == none);
    CHECK(star(empty_word) == empty_word);
    CHECK(concatenated(none, all_words({0})) == none);
    CHECK(all_words({}) == empty_word);
    CHECK(reversed(none) == none);
    CHECK(finite_set({}) == none);
    CHECK(finite_set({{3}}).automaton().letters == 4);
    CHECK_FALSE(finite_set({{3}}).contains({7}));
    CHECK(complement(none, {0, 1}) == all_words({0, 1}));
}

TEST_CASE("determinising what needs all sets of states is bounded") {
    // The twentieth letter from the end is a: 2^20 states.
    RegularLanguage end = finite_set({{0}});
    const RegularLanguage letter = finite_set({{0}, {1}});
    Budget budget;
    budget.memory = 1 << 20;
    for (int i = 0; i < 8; ++i) end = concatenated(end, letter);
    CHECK(concatenated(all_words({0, 1}), end, budget).automaton().states() == 512);
    for (int i = 0; i < 11; ++i) end = concatenated(end, letter);
    CHECK_THROWS_AS(concatenated(all_words({0, 1}), end, budget), BoundReached);
}

TEST_CASE("an induction over words needs tables, and rules for all letters of the words") {
    const RegularLanguage whole = finite_set({{0, 1}});
    const Table both{{{0}}, {{1}}}, first{{{0}}};
    CHECK(regular_induction(whole, {both}, 10).has_value());
    CHECK_FALSE(regular_induction(whole, {}, 10).has_value());
    CHECK_FALSE(regular_induction(whole, {first}, 10).has_value());
}
