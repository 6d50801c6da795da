#pragma once

#include <vector>

#include "base/budget.hpp"
#include "growth/morphic.hpp"
#include "system/d0l.hpp"

namespace algae {

/// A primitive word all of whose powers are factors of the language.
struct InfiniteRepetition {
    Word word;           // the least of its conjugates
    bool grows = false;  // whether it has a growing letter; then one letter generates it
    Symbol letter = 0;   // a growing letter that begins, or pushes, the repetition
};

/// All words of which every power is a factor of some h^n(w), one of each class of conjugates; none
/// exactly if the language is not repetitive. Decided, for every D0L system: Klouda and Starosta
/// (2015), "An algorithm for enumerating all infinite repetitions in a D0L-system"; that
/// repetitiveness is decidable is due to Ehrenfeucht and Rozenberg (1983) and to Mignosi and Seebold (1993).
///
/// Made injective, the morphism g has two kinds. Repetitions over letters that do not grow are what
/// pushing letters leave behind. The others are infinite words g^q(a) g^(2q)(a) ... that are
/// periodic: the period has each growing letter once, so it ends before the second occurrence of a,
/// and v is one exactly if the image of v is a power of the next word in the cycle, some power above 1.
/// Throws BoundReached if a repetition is longer than budget.memory allows.
///
/// Example: infinite_repetitions(d0l("a", {{'a', "ab"}, {'b', "ba"}})).empty()
std::vector<InfiniteRepetition> infinite_repetitions(const D0L& system, const Budget& budget = {});

/// Those with growing letters, of a system without names and without empty images of accessible letters.
std::vector<InfiniteRepetition> growing_repetitions(const Iterated& system, const Budget& budget = {});

}  // namespace algae
