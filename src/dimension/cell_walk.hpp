#pragma once

#include <cstdint>
#include <cstdlib>

#include "dimension/grid.hpp"

namespace algae {

/// The border that a segment goes over from one cell to the next; both where it goes through a
/// corner.
struct Crossing {
    bool sideways = false, upright = false;
    std::int64_t way = 0, whole = 1;  // how far along the segment, in units that do not matter

    /// The share of the segment before the border.
    double share() const { return static_cast<double>(way) / static_cast<double>(whole); }
};

/// Goes from cell to cell along a segment (Amanatides and Woo 1987) and calls `step(crossing)` at
/// each border, decided exactly. A cell holds its left and lower borders. O(cells).
template <class Step>
void walk_cells(GridPoint from, GridPoint to, Step&& step) {
    __extension__ using Wide = __int128;
    constexpr std::int64_t cell_width = std::int64_t{1} << Grid::fraction_bits;
    const auto way_to_border = [](std::int64_t coordinate, bool upward) {
        const std::int64_t within = coordinate & (cell_width - 1);
        return upward ? cell_width - within : within;
    };
    const bool right = to.x > from.x, up = to.y > from.y;
    const std::int64_t width = std::abs(to.x - from.x), height = std::abs(to.y - from.y);
    std::int64_t columns = std::abs(to.column() - from.column()),
                 rows = std::abs(to.row() - from.row());
    std::int64_t way_right = way_to_border(from.x, right), way_up = way_to_border(from.y, up);
    // Which border comes first: that of the column if `ahead` is negative, that of the row if it is
    // positive. As a cell holds its left and lower borders, going right or up one is in the next cell
    // on the border already, going left or down only beyond it.
    Wide ahead = Wide{way_right} * height - Wide{way_up} * width;
    const Wide per_column = Wide{cell_width} * height, per_row = Wide{cell_width} * width;
    while (columns > 0 || rows > 0) {
        Crossing crossing{rows == 0 || ahead < 0, columns == 0 || ahead > 0, 0, 1};
        if (columns > 0 && rows > 0 && ahead == 0) {
            crossing.sideways = right || !up;
            crossing.upright = up || !right;
        }
        crossing.sideways = crossing.sideways && columns > 0;
        crossing.upright = crossing.upright && rows > 0;
        crossing.way = crossing.sideways ? way_right : way_up;
        crossing.whole = crossing.sideways ? width : height;
        if (crossing.sideways) {
            way_right += cell_width;
            ahead += per_column;
            --columns;
        }
        if (crossing.upright) {
            way_up += cell_width;
            ahead -= per_row;
            --rows;
        }
        step(crossing);
    }
}

}  // namespace algae
