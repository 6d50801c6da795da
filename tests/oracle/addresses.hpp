#pragma once
// Attractors by their addresses: all compositions of so many maps.

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace oracle {

/// (x,y) -> (a x + b y + e, c x + d y + f), from the set of one state into that of another.
struct Placed {
    std::array<double, 6> numbers;
    std::size_t from = 0, to = 0;
};

/// The images of (x,y) under all compositions of `length` maps that lead from state 0 on.
std::vector<std::pair<double, double>> addressed_points(const std::vector<Placed>& maps,
                                                        std::size_t length, double x, double y,
                                                        std::size_t state = 0);

/// How far the first set reaches from the second, by comparing all pairs.
double farthest_from(const std::vector<std::pair<double, double>>& first,
                     const std::vector<std::pair<double, double>>& second);

}  // namespace oracle
