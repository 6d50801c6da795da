#pragma once

#include "algebra/sums.hpp"
#include "fold/fold.hpp"
#include "word/spelling.hpp"

namespace algae {

/// Every letter counts 1, brackets too: fold gives the length of the word.
///
/// Example: fold(d0l("F", {{'F', "F+F--F+F"}}), 3, length_lift()) == 148
inline auto length_lift() {
    return Lift{Sums{2}, [](Symbol) { return Integer(1); }};
}

/// The letter itself: fold gives the word.
inline auto word_lift() {
    return Lift{Words{}, [](Symbol a) { return Word{a}; }};
}

/// The letter's name: fold gives the word as text.
inline auto spelling_lift(const Alphabet& alphabet) {
    const Spellings spellings(alphabet);
    return Lift{spellings, [spellings](Symbol a) { return spellings.letter(a); }};
}

/// 1 for one letter, 0 for the others: fold counts its occurrences.
///
/// Example: fold(d0l("F", {{'F', "F+F--F+F"}}), 3, count_lift(0)) == std::vector<Integer>{64}
inline auto count_lift(Symbol counted) {
    // Brackets that are counted themselves count as letters, so they are plain here.
    return Lift{Vectors{1}, [counted](Symbol a) { return std::vector<Integer>{Integer(a == counted ? 1 : 0)}; }};
}

}  // namespace algae
