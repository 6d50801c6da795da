#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/budget.hpp"

namespace algae {

/// What a painter knows of a thing before looking closely: the box around it in the picture, and how
/// near it is on the whole.
struct Extent {
    double left = 0, right = 0, bottom = 0, top = 0;
    double depth = 0;     // larger is nearer
    bool slight = false;  // too small for anybody to see which of two such things is in front
};

/// The order in which things are painted, each over those before.
struct PaintingOrder {
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t>
        knotted;  // those that hide each other in a ring, so that no order is right
};

/// Whether the first of two things hides some of the second (above 0), the second some of the first
/// (below 0), or neither.
using Hiding = std::function<int(std::uint32_t, std::uint32_t)>;

/// An order in which everything comes after what it hides, and as far as that leaves free, by depth.
///
/// Things whose boxes meet are compared, except slight ones with each other; the relation is sorted
/// topologically, the farthest first. O(n log n) and one comparison for each pair of boxes that meet,
/// at most `most_comparisons`; beyond that depth decides.
PaintingOrder painting_order(std::span<const Extent> things, const Hiding& hiding,
                             const Budget& budget);

}  // namespace algae
