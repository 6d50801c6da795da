#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/budget.hpp"

namespace algae {

/// Cells of a square grid that are taken, and how far from any of them a place is: at once, by
/// looking at grids of cells 1, 2, 4, ... wide. Coordinates are from -half() up to half() - 1.
class Occupancy {
public:
    /// Nothing taken; half() is this power of two. Throws BoundReached if it takes more memory
    /// than the budget has: about a third of a byte for each cell.
    Occupancy(int half_exponent, const Budget& budget);

    std::int64_t half() const { return half_; }
    bool inside(std::int64_t x, std::int64_t y) const {
        return x >= -half_ && x < half_ && y >= -half_ && y < half_;
    }
    /// Marks a cell inside as taken. O(levels), and less where cells close by are taken.
    void take(std::int64_t x, std::int64_t y);
    bool taken(std::int64_t x, std::int64_t y) const {
        return bit(taken_[0], index(0, x + half_, y + half_));
    }
    /// Whether one of the 3 by 3 cells around a cell inside is taken.
    bool near(std::int64_t x, std::int64_t y) const {
        return bit(near_[0], index(0, x + half_, y + half_));
    }
    /// The greatest e such that no cell is taken within 2^e cells in both directions, by what the
    /// grids show: they may be up to twice as wide. `hint`, the last answer, makes it faster. For a
    /// cell inside that is not `near`; O(levels) at most.
    int empty_exponent(std::int64_t x, std::int64_t y, int hint) const;

private:
    using Bits = std::vector<std::uint64_t>;
    static bool bit(const Bits& bits, std::size_t at) { return bits[at >> 6] >> (at & 63) & 1; }
    static void set(Bits& bits, std::size_t at) { bits[at >> 6] |= std::uint64_t{1} << (at & 63); }
    std::size_t index(int level, std::int64_t column, std::int64_t row) const {
        return (static_cast<std::size_t>(row >> level) << (exponent_ + 1 - level)) +
               static_cast<std::size_t>(column >> level);
    }

    int exponent_;
    std::int64_t half_;
    std::vector<Bits> taken_;  // of each level: whether something in the cell is taken
    std::vector<Bits> near_;   // the same of one of the 3 by 3 cells around
};

inline int Occupancy::empty_exponent(std::int64_t x, std::int64_t y, int hint) const {
    const std::int64_t column = x + half_, row = y + half_;
    const int last = static_cast<int>(near_.size()) - 1;
    int level = hint < 0 ? 0 : hint > last ? last : hint;
    while (level > 0 && bit(near_[static_cast<std::size_t>(level)], index(level, column, row)))
        --level;
    while (level < last &&
           !bit(near_[static_cast<std::size_t>(level) + 1], index(level + 1, column, row)))
        ++level;
    return level;
}

}  // namespace algae
