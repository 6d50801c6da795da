#include "dimension/box_counter.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "dimension/cell_walk.hpp"

namespace algae {

namespace {

constexpr std::int64_t cell_width = std::int64_t{1} << Grid::fraction_bits;
constexpr int most_bits = 31;

/// How many bits a column needs that lies so many cells from the origin.
int bits_for(double reach) {
    int bits = 3;
    while (bits <= most_bits && !(reach < std::ldexp(1.0, bits))) ++bits;
    if (bits > most_bits)
        throw BoundReached(Bound::method, "the finest cells are too fine: expected at most 2^" +
                                              std::to_string(most_bits) +
                                              " of them side by side; use fewer scales");
    return bits;
}

}  // namespace

TouchedCells::TouchedCells(const Grid& grid, int bits, CellSet::Storage storage,
                           const Budget& budget)
    : grid_(grid),
      scale_(static_cast<double>(cell_width) / grid.cell),
      end_(std::ldexp(1.0, bits + Grid::fraction_bits)),
      cells_(bits, storage, budget) {}

TouchedCells::TouchedCells(const Grid& grid, double reach, const Budget& budget)
    : TouchedCells(grid, bits_for(reach + 1),
                   reach + 1 < std::ldexp(1.0, CellSet::most_dense_bits) ? CellSet::Storage::dense
                                                                         : CellSet::Storage::sparse,
                   budget) {}

void TouchedCells::cross(GridPoint to) {
    const std::int64_t columns = to.column() - here_.column(), rows = to.row() - here_.row();
    if (rows == 0 && columns == 1) {
        cell_.right();
    } else if (rows == 0 && columns == -1) {
        cell_.left();
    } else if (columns == 0 && rows == 1) {
        cell_.up();
    } else if (columns == 0 && rows == -1) {
        cell_.down();
    } else {
        cross_many(to);
        return;
    }
    cells_.mark(cell_);
}

void TouchedCells::cross_many(GridPoint to) {
    const bool right = to.x > here_.x, up = to.y > here_.y;
    walk_cells(here_, to, [&](const Crossing& crossing) {
        if (crossing.sideways) right ? cell_.right() : cell_.left();
        if (crossing.upright) up ? cell_.up() : cell_.down();
        cells_.mark(cell_);
    });
}

void TouchedCells::outside(Point point) const {
    throw Error("the figure has the point (" + std::to_string(point.x) + ", " +
                std::to_string(point.y) +
                "), expected all points to lie within its box, which numbers can hold");
}

void BoxCounter::polygon(std::span<const Point> corners) {
    if (corners.empty()) return;
    move_to(corners.back());
    for (const Point corner : corners) line_to(corner);
    lifted_ = true;
}

}  // namespace algae
