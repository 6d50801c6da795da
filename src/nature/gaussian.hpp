#pragma once

#include <cstdint>

#include "rewrite/draws.hpp"

namespace algae {

/// A number strictly between 0 and 1 from 64 random bits: the middle of one of 2^52 equal parts.
///
/// Example: unit_interval(0) == 0x1p-53
constexpr double unit_interval(std::uint64_t bits) {
    return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

/// Independent standard normal numbers, each by its position alone: they are the same in whatever
/// order and by however many threads they are asked for.
///
/// Numbers 2k and 2k + 1 are made from the numbers 2k and 2k + 1 of Draws (Box and Muller, A note
/// on the generation of random normal deviates, 1958).
class Gaussians {
public:
    /// The stream of a seed with this number; streams of a seed are independent of each other.
    Gaussians(std::uint64_t seed, std::uint64_t stream) : draws_(seed, stream) {}

    /// The number at this position, counted from 0; mean 0 and variance 1. O(1).
    ///
    /// Example: Gaussians(1, 0).at(5) == Gaussians(1, 0).at(5)
    double at(std::uint64_t position) const;

private:
    Draws draws_;
};

}  // namespace algae
