#pragma once
// Cellular automata by the definition: every cell, every neighbour, one after the other.

#include <functional>
#include <utility>
#include <vector>

namespace oracle {

using Rows = std::vector<std::vector<int>>;

/// What the cell in the middle of these states becomes.
using Next = std::function<int(const std::vector<int>&)>;

/// The grid after one step; neighbours as (column, row) steps. Beyond the edges stands `outside`, or the
/// other side if it is negative.
Rows next_cells(const Rows& cells, const std::vector<std::pair<int, int>>& neighbours,
                const Next& next, int outside);

}  // namespace oracle
