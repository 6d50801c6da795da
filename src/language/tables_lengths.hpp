#pragma once

#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "language/membership.hpp"
#include "language/tables_relations.hpp"

namespace algae {

/// A derivation by these tables, one a step, of an accepted word, and of a shortest that they
/// derive. There must be one. What leaves no letter in the last word is erased as soon as the
/// tables can. Time and memory O(steps * letters * states^2), time also times the size of the
/// rules. Throws BoundReached if the tables of lengths take more than budget.memory or the words
/// have more than budget.letters letters together.
Derivation shortest_derivation(const ET0L& system, const UsefulStates& automaton,
                               const std::vector<std::uint32_t>& tables, const Budget& budget = {});

}  // namespace algae
