#include "dimension/box_counter.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace algae {

namespace {

__extension__ using Wide = __int128;

constexpr std::int64_t cell_width = std::int64_t{1} << Grid::fraction_bits;
constexpr int most_bits = 31;

/// How many bits a column needs that lies so many cells from the origin.
int bits_for(double reach) {
    int bits = 3;
    while (bits <= most_bits && !(reach < std::ldexp(1.0, bits))) ++bits;
    if (bits > most_bits)
        throw BoundReached("the finest cells are too fine: expected at most 2^" +
                           std::to_string(most_bits) + " of them side by side; use fewer scales");
    return bits;
}

/// How far a coordinate is from the border of its cell that it moves to.
std::int64_t way_to_border(std::int64_t coordinate, bool upward) {
    const std::int64_t within = coordinate & (cell_width - 1);
    return upward ? cell_width - within : within;
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
        cross_many(to, columns, rows);
        return;
    }
    cells_.mark(cell_);
}

void TouchedCells::cross_many(GridPoint to, std::int64_t columns, std::int64_t rows) {
    const bool right = columns > 0, up = rows > 0;
    const std::int64_t width = std::abs(to.x - here_.x), height = std::abs(to.y - here_.y);
    // Which border comes first: that of the column if `ahead` is negative, that of the row if it is
    // positive. A cell holds its left and lower borders, so going right or up one is in the next cell
    // on the border already, going left or down only beyond it.
    Wide ahead =
        Wide{way_to_border(here_.x, right)} * height - Wide{way_to_border(here_.y, up)} * width;
    const Wide per_column = Wide{cell_width} * height, per_row = Wide{cell_width} * width;
    columns = std::abs(columns);
    rows = std::abs(rows);
    while (columns > 0 || rows > 0) {
        bool sideways = rows == 0 || ahead < 0, upright = columns == 0 || ahead > 0;
        if (columns > 0 && rows > 0 && ahead == 0) {
            sideways = right || !up;
            upright = up || !right;
        }
        sideways = sideways && columns > 0;
        upright = upright && rows > 0;
        if (sideways) {
            right ? cell_.right() : cell_.left();
            ahead += per_column;
            --columns;
        }
        if (upright) {
            up ? cell_.up() : cell_.down();
            ahead -= per_row;
            --rows;
        }
        cells_.mark(cell_);
    }
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
