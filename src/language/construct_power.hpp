#pragma once

#include <vector>

#include "base/budget.hpp"
#include "system/d0l.hpp"

namespace algae {

/// The k systems with rules h^k and axioms w, h(w), ..., h^(k-1)(w) of a system with rules h and axiom w:
/// system i derives the words of generations i, i + k, i + 2k, ... so the union of the k languages is
/// L(G) and their sequences, one word of each in turn, are its sequence. Letters that are not accessible
/// become themselves. O(length of the h^k(a)).
///
/// Throws Error if `power` is 0, and BoundReached if the words have more than budget.letters letters.
///
/// Example: powers(d0l("b", {{'a', "ab"}, {'b', "a"}}), 2)[1].axiom.size() == 1
std::vector<D0L> powers(const D0L& system, unsigned power, const Budget& budget = {});

}  // namespace algae
