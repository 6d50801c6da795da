#pragma once

// The steps of the decisions of D0L equivalence that are tested by themselves.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "language/language.hpp"

namespace algae {

/// The same system as an 0L system, one successor a letter.
///
/// Example: ol_of(d0l("a", {{'a', "aa"}})).successors[0].size() == 1
OL ol_of(const D0L& system);

/// What a further letter makes of an overflow.
struct OverflowStep {
    std::optional<Overflow> next;  // none if the images differ at a letter that both have
    std::size_t agreed = 0;  // so many more letters does the shorter image share with the other
};

/// From u with this overflow to u a: what is ahead and the images of a are compared. Linear time.
///
/// Example: overflow_step(over_common_alphabet(d0l("a", {{'a', "ab"}}), d0l("a", {{'a', "a"}})), {}, 0).next->word == Word{1}
OverflowStep overflow_step(const SequencePair& systems, const Overflow& overflow, Symbol letter);

/// The result of an attempt to close these states.
struct BalanceAttempt {
    std::optional<Balance> balance;  // if the proof holds
    /// Otherwise: the first whose word does not lead back through these states.
    std::uint64_t generation = 0;
};

/// Tries the proof with these states, of which the first is the empty overflow, and the accessible
/// letters of the left system. Time O(states * size of the rules) a step; the maps repeat since there are
/// finitely many of them (found as Brent 1980 does, so with less than 3 times the least number of steps).
/// Throws what budget.check throws, and BoundReached if the maps take more than budget.memory.
///
/// Example: try_balance(over_common_alphabet(d0l("a", {{'a', "ab"}}), d0l("a", {{'a', "ab"}})), {Overflow{}}).balance->steps == 1
BalanceAttempt try_balance(const SequencePair& systems, std::vector<Overflow> states,
                           const Budget& budget = {});

/// All words of a D0L system with a finite language. Throws BoundReached if they take more than
/// budget.memory.
///
/// Example: words_of(d0l("ab", {{'a', "b"}, {'b', "a"}})).size() == 2
std::set<Word> words_of(const D0L& system, const Budget& budget = {});

/// Whether every number from 0 on is one of these, or of these arithmetic progressions (first, difference).
///
/// Example: covers_all({0}, {{1, 2}, {2, 2}}) && !covers_all({}, {{0, 2}})
bool covers_all(const std::vector<std::uint64_t>& single,
                const std::vector<std::pair<std::uint64_t, std::uint64_t>>& progressions);

/// What each letter of the system becomes in so many steps, by symbol. Throws BoundReached where these words take more than
/// budget.memory.
///
/// Example: power_of_rules(d0l("a", {{'a', "aa"}}), 3)[0].size() == 8
std::vector<Word> power_of_rules(const D0L& system, std::uint64_t exponent,
                                 const Budget& budget = {});

/// Whether the language of one D0L system is within that of another, both infinite.
struct LanguageInclusion {
    std::optional<bool> included;  // nothing: neither was found
    /// Where it is: by generation, words and sections of the left sequence that are words and sections of the right one, all words of
    /// the left language among them.
    std::vector<std::pair<std::uint64_t, std::uint64_t>> words;
    std::vector<SectionMatch> sections;
    std::optional<LanguageDifference> difference;  // where it is not; of the left language
    std::uint64_t generations = 0;                 // of the left system that were looked at
};

/// D0L inclusion by sections (see language_equality.cpp), where the words of the left language come in arithmetic progressions of the
/// generations of the right system. Nothing where they were not found to, nor a word outside, in the first 512 generations. Throws
/// what equal_languages throws; neither language may be finite.
///
/// Example: *included_language(d0l("aa", {{'a', "aa"}}), d0l("a", {{'a', "aa"}})).included
LanguageInclusion included_language(const D0L& left, const D0L& right, const Budget& budget = {});

}  // namespace algae
