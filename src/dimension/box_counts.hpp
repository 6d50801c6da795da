#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "dimension/grid.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// How wide cells are: `count` scales, the first one `coarsest`, each one `ratio` times finer than
/// the one before.
struct BoxScales {
    double coarsest = 1;
    double ratio = 2;
    std::size_t count = 12;

    double cell(std::size_t scale) const;
};

/// Scales with the longer side of the box as the coarsest one. Throws Error if the box is empty,
/// is one point only, or goes beyond the range of numbers.
///
/// Example: scales_of(Box{{0, 0}, {4, 1}, false}, 2, 12).cell(11) == 4.0 / 2048
BoxScales scales_of(const Box& box, double ratio, std::size_t count);

/// The numbers of cells that something touches, for every scale and every offset of the grid.
struct BoxCounts {
    BoxScales scales;
    /// Of each scale, coarsest first: one number for each offset.
    std::vector<std::vector<std::uint64_t>> counts;
    /// The size of the smallest detail: the length of a segment, the side of a pixel; 0 if the
    /// thing measured has none. Finer cells see lines or points, not the shape.
    double detail = 0;
    /// What was counted, with multiplicity, and what one of them is called.
    std::uint64_t parts = 0;
    /// The longer side of the whole; 0 if it is the coarsest cell.
    double whole = 0;
    std::string part = "segment";
    /// The dimension of the space it lies in, which no dimension exceeds.
    int space = 2;

    /// The mean over the offsets.
    double mean(std::size_t scale) const;
};

/// Counts the cells that the segments of a figure touch, in the half-open cells of Grid, by going
/// from cell to cell along each segment (Amanatides and Woo 1987), never by a raster. Of polygons,
/// the outlines are counted.
///
/// `offsets` move each grid against the figure's lower left corner, in shares of the coarsest cell;
/// for ratios other than 2, of the scale's own cell. With ratio 2 only the finest scale is counted
/// from segments: a square of 2 by 2 cells is touched where one of them is. All offsets are counted
/// in one pass over the figure. O(segments * offsets) time for ratio 2, * scales for others; memory
/// for the bits of the finest cells, at most budget.memory.
///
/// Throws Error if nothing is drawn, BoundReached, Interrupted.
BoxCounts box_counts(const Figure& figure, const BoxScales& scales, std::span<const Point> offsets,
                     const Budget& budget);

}  // namespace algae
