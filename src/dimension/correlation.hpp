#pragma once

#include <cstddef>
#include <cstdint>

#include "base/budget.hpp"
#include "dimension/points.hpp"
#include "dimension/scaling.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// How many points stand for the set, and which.
struct CorrelationSample {
    std::size_t points = 20'000;
    std::uint64_t seed = 1;
};

/// Of how many pairs of the points the distance is at most each of these radii, the first one
/// `greatest` and each half of the one before. Points are compared with those in the cells around
/// theirs, cells as wide as `greatest`. O(points log points + pairs in those cells).
///
/// Throws Error unless `greatest` is above 0, BoundReached, Interrupted.
std::vector<std::uint64_t> near_pairs(const PointSet& points, double greatest, std::size_t radii,
                                      const Budget& budget);

/// The correlation sum (Grassberger and Procaccia, Physica D 9, 1983): the share of pairs of points
/// that are at most a radius apart, which grows as the radius to the power of the correlation
/// dimension. Of more points than the sample takes, an even sample stands for all. Radii are an
/// eighth of the longest side and its halves; used are those within which a point has at least four
/// others on average.
///
/// Throws Error if there are fewer than two points or all are the same, BoundReached, Interrupted.
Scaling correlation(const PointSet& points, const CorrelationSample& sample, const Budget& budget);

/// The same of points spread evenly, by `even_sample`, along what a figure draws.
Scaling correlation(const Figure& figure, const CorrelationSample& sample, const Budget& budget);

}  // namespace algae
