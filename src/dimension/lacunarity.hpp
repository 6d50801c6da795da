#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/budget.hpp"
#include "dimension/points.hpp"
#include "dimension/scaling.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// A rectangle of square cells of which some are filled. One row of them is a part of a line.
struct CellRectangle {
    std::size_t columns = 0, rows = 0;
    std::vector<bool> filled;  // row after row
    double cell = 1;           // the side of a cell
};

/// The lacunarity (Allain and Cloitre, Phys. Rev. A 44, 1991) for boxes of these sides, in cells: a
/// box glides over all places within the rectangle, from cell to cell, and with M how many filled
/// cells it holds, lacunarity is the mean of M^2 over the square of the mean of M. It is 1 for what
/// looks the same everywhere, and greater the more the gaps differ. In one row a box is a stretch.
/// O(cells) time for each side, 8 bytes a cell.
///
/// Throws Error if no cell is filled or a side is 0 or longer than a side of the rectangle,
/// BoundReached, Interrupted.
///
/// Example: lacunarities({2, 2, {true, false, false, true}, 1}, std::vector{1ul}, Budget())[0] == 2
std::vector<double> lacunarities(const CellRectangle& cells, std::span<const std::size_t> sides,
                                 const Budget& budget);

/// Lacunarity for boxes with powers of two as sides. Of a self-similar set it falls as the side to
/// the power of its dimension less that of the space. Used are sides from four cells to an eighth
/// of the rectangle's shorter side.
///
/// Throws as `lacunarities` does.
Scaling lacunarity(const CellRectangle& cells, const Budget& budget);

/// The cells that a figure touches, in the square around it, with at most `most` cells a side and
/// none shorter than a segment. The figure lies in its middle. Throws Error if nothing is drawn.
CellRectangle drawn_cells(const Figure& figure, std::size_t most, const Budget& budget);

/// The cells that hold a point: of points with a size, such as pixels, one for each in the rectangle
/// around them; otherwise in the square, and as small as leaves eight points in a filled cell on
/// average. Throws Error if all points are the same or lie in space, BoundReached.
CellRectangle filled_cells(const PointSet& points, const Budget& budget);

}  // namespace algae
