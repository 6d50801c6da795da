#pragma once

#include <cstddef>
#include <cstdint>

#include "base/budget.hpp"
#include "dimension/points.hpp"
#include "dimension/scaling.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// The length of the segment that lies within a disc.
///
/// Example: length_within({-2, 0}, {2, 0}, {0, 0}, 1) == 2
double length_within(Point from, Point to, Point centre, double radius);

/// From how many places, and which.
struct Sandboxes {
    std::size_t centres = 500;
    std::uint64_t seed = 1;
};

/// The mean length of what a figure draws within discs around random places on it (the sandbox
/// method: Tel, Fueloep and Vicsek, Physica A 159, 1989): it grows as the radius to the power of the
/// dimension, that of correlation where parts of the figure differ in density. What is drawn twice
/// counts twice. Radii are an eighth of the whole and its halves down to the length of a segment,
/// of which those of at least four segments are used. The figure is drawn three times and not kept.
/// O(segments * centres) time.
///
/// Throws Error if nothing is drawn or there are no centres, BoundReached, Interrupted.
Scaling mass(const Figure& figure, const Sandboxes& sandboxes, const Budget& budget);

/// The mean number of other points within balls around random points of the set; used are radii that
/// hold at least four on average. O(points * centres).
///
/// Throws Error if all points are the same or there are no centres, Interrupted.
Scaling mass(const PointSet& points, const Sandboxes& sandboxes, const Budget& budget);

}  // namespace algae
