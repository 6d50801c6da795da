#pragma once

#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "turtle/pose.hpp"

namespace algae {

/// A walk whose steps are Gaussian in each coordinate: x(t + 1) = x(t) + Dx, with Dx of mean 0.
struct RandomWalk {
    int dimensions = 2;  // 1, 2 or 3
    std::uint64_t steps = 10000;
    double deviation = 1;  // of each coordinate of a step
    std::uint64_t seed = 1;
};

/// The places of a walk from the origin, one more than it has steps; coordinates beyond its
/// dimensions are 0. A walk of fewer steps with the same seed is its beginning. O(steps).
///
/// Throws Error unless it has 1 to 3 dimensions and a deviation above 0, BoundReached if the places
/// take more than budget.memory, Interrupted.
///
/// Example: random_walk({2, 100, 1, 1}, Budget()).size() == 101
std::vector<Vector> random_walk(const RandomWalk& walk, const Budget& budget);

}  // namespace algae
