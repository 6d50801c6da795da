#pragma once
// dimension: exact and measured dimensions of what systems draw.

#include <cmath>
#include <cstdint>
#include <vector>

#include "turtle/canvas.hpp"

namespace algae {

/// A grid of squares. Cell (i, j) is the half-open square of the points with
/// i * cell <= x - origin.x < (i + 1) * cell, and the same for y: every point lies in exactly one
/// cell, so what runs along a border is counted once.
///
/// Coordinates are rounded to a fraction 2^-20 of a cell before anything is decided, and every
/// decision after that is exact. So points of a lattice whose doubles differ in the last digits are
/// one point, and a lattice point on a border stays on it.
struct Grid {
    Point origin;
    double cell = 1;

    static constexpr int fraction_bits = 20;

    /// The grid of this cell, moved by shares (0 <= share < 1) of `around`, whose cell (0, 0) holds
    /// the lower left corner of the box.
    static Grid before(const Box& box, double cell, Point shares, double around) {
        return {{box.low.x - shares.x * around, box.low.y - shares.y * around}, cell};
    }
    /// The place of a point in it, which must lie within 2^42 cells of the origin.
    struct GridPoint at(Point point) const;
    bool operator==(const Grid&) const = default;
};

/// A point in units of 2^-20 of a cell, relative to the origin of a grid.
struct GridPoint {
    std::int64_t x = 0, y = 0;

    std::int64_t column() const { return x >> Grid::fraction_bits; }
    std::int64_t row() const { return y >> Grid::fraction_bits; }
    bool operator==(const GridPoint&) const = default;
};

inline GridPoint Grid::at(Point point) const {
    const double parts = static_cast<double>(std::int64_t{1} << fraction_bits) / cell;
    return {static_cast<std::int64_t>(std::floor((point.x - origin.x) * parts + 0.5)),
            static_cast<std::int64_t>(std::floor((point.y - origin.y) * parts + 0.5))};
}

/// The first `count` places of a sequence that fills the unit square evenly (Roberts 2018: multiples
/// of the powers of the plastic number, modulo 1), for offsets of grids. The same on every machine.
///
/// Example: even_offsets(1)[0].x > 0.5
std::vector<Point> even_offsets(std::size_t count);

}  // namespace algae
