#pragma once

#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "language/regular_language.hpp"

namespace algae {

// The words of a regular language. Shortlex order is by the numbers of the symbols.

/// Example: is_empty(RegularLanguage())
bool is_empty(const RegularLanguage& language);

/// The first word in shortlex order, if there is one. Linear time.
///
/// Example: shortest_word(plus(finite_set({{1}, {0, 0}}))) == Word{1}
std::optional<Word> shortest_word(const RegularLanguage& language);

/// Whether there are finitely many words. Linear time.
///
/// Example: !is_finite(plus(finite_set({{0}})))
bool is_finite(const RegularLanguage& language);

/// How many words there are; nothing if there is no end to them. Linear time.
///
/// Example: number_of_words(finite_set({{}, {0}})) == Integer(2)
std::optional<Integer> number_of_words(const RegularLanguage& language);

/// How many words of this length there are, by the automaton's transitions: O(length * states * letters).
///
/// Example: number_of_words(all_words({0, 1}), 100) == power(Integer(2), 100)
Integer number_of_words(const RegularLanguage& language, std::size_t length);

/// The words of at most `longest` letters in shortlex order. Throws BoundReached if they take more
/// than budget.memory.
///
/// Example: words_up_to(all_words({0}), 2) == std::vector<Word>{{}, {0}, {0, 0}}
std::vector<Word> words_up_to(const RegularLanguage& language, std::size_t longest, const Budget& budget = {});

/// The first word in shortlex order that is in the first language and not in the second: nothing if the
/// first is contained in the second.
///
/// Example: first_outside(all_words({0}), finite_set({{}, {0, 0}})) == Word{0}
std::optional<Word> first_outside(const RegularLanguage& inner, const RegularLanguage& outer, const Budget& budget = {});

/// The first word in shortlex order that is in one language only: nothing if they are equal.
///
/// Example: !first_difference(star(plus(finite_set({{0}}))), all_words({0}))
std::optional<Word> first_difference(const RegularLanguage& left, const RegularLanguage& right, const Budget& budget = {});

}  // namespace algae
