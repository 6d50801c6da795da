#pragma once

#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "language/automaton.hpp"

namespace algae {

/// A regular language, kept as its minimal automaton: languages are equal when their automata are.
/// Words are over the symbols of some alphabet that the caller knows. Operations that make automata
/// grow throw BoundReached when one takes more than budget.memory.
class RegularLanguage {
public:
    /// No word at all.
    RegularLanguage() : RegularLanguage(Dfa{0, 0, {0}, {}}) {}
    explicit RegularLanguage(const Dfa& automaton) : automaton_(minimal(automaton)) {}
    explicit RegularLanguage(const Nfa& automaton, const Budget& budget = {})
        : RegularLanguage(determinised(automaton, budget)) {}

    const Dfa& automaton() const { return automaton_; }
    bool contains(const Word& word) const { return automaton_.accepts(word); }
    bool operator==(const RegularLanguage&) const = default;

private:
    Dfa automaton_;
};

/// A finite set of words.
///
/// Example: finite_set({{0}, {0, 1}}).contains({0, 1})
RegularLanguage finite_set(const std::vector<Word>& words);

/// All words over these letters.
///
/// Example: all_words({0, 1}) == star(finite_set({{0}, {1}}))
RegularLanguage all_words(const std::vector<Symbol>& letters);

/// Union.
///
/// Example: united(finite_set({{0}}), finite_set({{1}})) == finite_set({{0}, {1}})
RegularLanguage united(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget = {});
/// Example: intersected(all_words({0}), finite_set({{0}, {1}})) == finite_set({{0}})
RegularLanguage intersected(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget = {});
/// The words of the first that are not in the second; the complement of a language over some
/// letters is difference(all_words(letters), language).
///
/// Example: difference(finite_set({{0}, {1}}), finite_set({{1}, {2}})) == finite_set({{0}})
RegularLanguage difference(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget = {});
/// The words that are in one of the two only.
RegularLanguage symmetric_difference(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget = {});
/// All words over the letters that are not in the language.
///
/// Example: complement(all_words({0, 1}), {0, 1}) == RegularLanguage()
RegularLanguage complement(const RegularLanguage& language, const std::vector<Symbol>& letters, const Budget& budget = {});

/// Example: concatenated(finite_set({{0}, {}}), finite_set({{1}})) == finite_set({{1}, {0, 1}})
RegularLanguage concatenated(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget = {});
/// Example: star(RegularLanguage()) == finite_set({{}})
RegularLanguage star(const RegularLanguage& language, const Budget& budget = {});
/// One word of the language or several after each other.
///
/// Example: !plus(finite_set({{0}})).contains({})
RegularLanguage plus(const RegularLanguage& language, const Budget& budget = {});
/// Example: reversed(finite_set({{0, 1}})) == finite_set({{1, 0}})
RegularLanguage reversed(const RegularLanguage& language, const Budget& budget = {});

}  // namespace algae
