#pragma once

// Languages of systems with context: their words, automata that accept all of them, and measures of words that every step
// raises.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "language/detail/proof.hpp"
#include "language/detail/regular.hpp"
#include "language/language.hpp"
#include "system/system.hpp"

namespace algae {

/// How far words of a system are looked at: so many words, and so many letters of all of them.
struct SearchOfWords {
    std::size_t words = 100'000;
    std::uint64_t letters = 2'000'000;
    /// No word is longer; where no rule is erasing, such words have no shorter descendants.
    std::optional<std::size_t> longest = {};
};

/// Words that a system derives from its axiom, breadth first, each with the one that it comes from.
struct FoundWords {
    std::vector<Word> words;
    std::vector<std::size_t> from;  // the first one comes from itself
    std::map<Word, std::size_t> numbers;
    bool is_all = false;  // there are no others that are not too long

    bool has(const Word& word) const { return numbers.count(word) > 0; }
    /// The derivation of one of them.
    Derivation derivation(std::size_t number) const;
};

/// The search ends with a word that is `wanted`, if it is found. Throws what budget.check throws.
FoundWords found_words(const IL& system, const SearchOfWords& search, const Budget& budget,
                       const std::optional<Word>& wanted = {});

/// All words of the language, sorted, if they are found to be so many at most.
std::optional<std::vector<Word>> all_words_of(const IL& system, const Budget& budget);

/// An automaton that accepts the axiom and whatever an accepted word may become in one step, and no word outside `outer`: a proof
/// that L(G) lies within. Nothing if none is found. The methods, in this order: words are told apart by the state in which the
/// automaton of `outer` reads them, their last letters, the letters seen and lengths modulo 2 and 3, and what derived words need is
/// added until nothing is missing; the same from right to left; and what leads outside in one step is taken away from `outer`
/// until no more is.
///
/// Example: invariant_within(il("ab", {"a > b -> aa"}), concatenated(all_words({0}), finite_set({{1}})))
std::optional<RegularLanguage> invariant_within(const IL& system, const RegularLanguage& outer,
                                                const Budget& budget = {});

/// Whether the language has the axiom and all that its words may become in one step; nothing if the contexts need too many states.
std::optional<bool> is_closed(const IL& system, const RegularLanguage& language,
                              const Budget& budget = {});

/// The words that words of a regular language become in one step, by successors that are not empty and at least once one of two
/// letters or more; nothing if the contexts need too many states.
std::optional<RegularLanguage> longer_successors(const IL& system, const RegularLanguage& language,
                                                 const Budget& budget = {});

/// That every word of the left side is in `right` (that there is none where it is null; that none is `word` if there is one), where
/// systems with context occur in the left side in places that more words make larger; nothing if no invariants are found.
std::optional<steps::Invariant> by_invariants(const Language& left, const Language& right,
                                              const std::optional<Word>& word,
                                              const Alphabet& alphabet, const Budget& budget);

/// Whether a system with context occurs in the expression.
bool has_context(const Language& language);

/// Some short words that may be in the language, in no order: the first ones of systems with context, and what operations make of such.
std::vector<Word> first_words(const LanguageTree& language, const Budget& budget);

/// A proof that L(G) is infinite, if one is found.
std::optional<steps::Measured> endless_measure(const SourceSystem& system, const Budget& budget);

}  // namespace algae
