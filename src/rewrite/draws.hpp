#pragma once

#include <cstdint>

namespace algae {

/// The numbers that a random derivation uses. Each depends on the seed, the generation and the
/// position of the module that is rewritten, and on nothing else: neither on the order of the work
/// nor on the machine, so a seed stands for one word everywhere.
///
/// The numbers of a generation g are those of SplitMix64 (Steele, Lea and Flood, Fast splittable
/// pseudorandom number generators, 2014) started from mix(mix(seed) + g): the one of position p
/// is mix(start + (p + 1) * 0x9E3779B97F4A7C15), 64 bits, where mix is its output function. A rule
/// with the probabilities p_1, p_2, ... before and with it is taken if the number, read as a binary
/// fraction from 0 up to 1, is the first below p_1 + p_2 + ...; sums are rounded down to 64 bits.
class Draws {
public:
    /// For the generation that is rewritten; the axiom is generation 0.
    Draws(std::uint64_t seed, std::uint64_t generation) : start_(mix(mix(seed) + generation)) {}

    /// The number for the module at this position, counted from 0.
    ///
    /// Example: Draws(1, 0).at(5) == Draws(1, 0).at(5)
    std::uint64_t at(std::uint64_t position) const { return mix(start_ + (position + 1) * golden); }

    /// The number by which the table of this step is picked.
    std::uint64_t of_table() const { return mix(~start_); }

    /// A number below `bound` (of at most 32 bits), all equally likely: the whole part of
    /// bound * number / 2^64.
    ///
    /// Example: Draws::scaled(std::uint64_t{1} << 63, 6) == 3
    static constexpr std::uint64_t scaled(std::uint64_t number, std::uint64_t bound) {
        return ((number >> 32) * bound + (((number & 0xFFFFFFFF) * bound) >> 32)) >> 32;
    }

private:
    static constexpr std::uint64_t golden = 0x9E3779B97F4A7C15;

    //> mix
    static constexpr std::uint64_t mix(std::uint64_t z) {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return z ^ (z >> 31);
    }
    //< mix

    std::uint64_t start_;
};

}  // namespace algae
