#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "dimension/box_counts.hpp"
#include "dimension/recurrent_set.hpp"

namespace algae {

/// How many cells of square grids a recurrent set K touches, itself and not some generation of it.
///
/// Scale j counts the unit cells that mu^(j levels) K touches, so that every scale shows the same set
/// in the same direction: without the wobble of other ratios. Cells are in parts of the longer side
/// of the set.
struct LimitCounts {
    BoxCounts boxes;
    std::size_t levels = 1;  // generations from one scale to the next
};

struct LimitCounting {
    std::size_t places = 16;             // of the grid, moved and turned at random
    std::uint64_t seed = 1;              // of the places
    std::uint64_t most_cells = 400'000;  // touched in the finest scale, about
    bool coinciding = false;             // parts coincide: each is looked at once in a place
};

/// Counts by going down from the whole to ever smaller parts, depth first: a part whose disc lies in
/// one cell touches it; a part all of whose cells are known to be touched need not be looked at; one
/// point of each part is known. So the work is that of the cells touched, whatever the generation whose segments would be as small.
/// Parts smaller than 10^-7 of a cell that lie on a border count for the cell of their middle.
///
/// Scales go from about 8 cells across (2 where the ratio is large) to where about `most_cells` are touched, but at least 4 scales, or 2^40 lie across.
/// Uses all processors; the numbers do not depend on how many there are. Throws BoundReached,
/// Interrupted.
LimitCounts limit_counts(const RecurrentSet& set, const LimitCounting& options = {},
                         const Budget& budget = {});

}  // namespace algae
