#pragma once

#include <cstdint>

#include "base/budget.hpp"
#include "system/lsystem.hpp"

namespace algae::cli {

/// Prints how many axes and edges of each order the axial tree of generation n has. Edges are the
/// symbols whose names begin with a letter; signs such as + only say how the turtle turns.
void print_axes(const LSystem& system, std::uint64_t n, bool json, const Budget& budget);

}  // namespace algae::cli
