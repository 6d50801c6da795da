#pragma once

#include <cstdint>

#include "base/budget.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// How many different segments and end points of segments a figure has. Points are the same when
/// they round to the same point of a fine grid, a millionth of a step, so that doubles that stand
/// for the same number count once.
struct Trace {
    std::uint64_t distinct_segments = 0;  // direction does not matter
    std::uint64_t vertices = 0;
};

/// Draws the figure once, in memory for every segment: throws BoundReached if that is more than
/// budget.memory.
Trace trace(const Figure& figure, const Budget& budget);

}  // namespace algae
