#pragma once

#include <optional>

#include "language/tables_finishing.hpp"
#include "language/tables_finiteness.hpp"

namespace algae {

/// What makes L(G) infinite, by the theorem of `finiteness`, if it is there: the search in the
/// graph of finishing sets with the letters of two and three courses. Of the first few the one with
/// the shortest courses. Throws BoundReached if the graph takes more than budget.memory.
std::optional<EndlessTables> first_round(const ET0L& system, const FinishingSets& sets,
                                         const Budget& budget = {});

}  // namespace algae
