#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/budget.hpp"
#include "dimension/box_counts.hpp"

namespace algae {

/// Points of a line, of the plane or of space.
struct PointSet {
    int columns = 2;  // coordinates of a point, 1 to 3; the others are 0
    std::vector<std::array<double, 3>> points;
    /// The size of a point, where it has one (the side of a pixel); otherwise 0.
    double detail = 0;
    /// What one of them is called.
    std::string part = "point";
};

/// The points in a text: one a line, 1 to 3 numbers with commas, semicolons or white space between
/// them. Empty lines and what follows # are skipped, and a first line of names. `name` is what
/// messages call the text.
///
/// Throws Diagnostics, with line and column, where something else stands; Error if there are no
/// points.
///
/// Example: read_points("x, y\n0, 0.5\n1 -2e3\n", "two.csv").points[1][1] == -2000
PointSet read_points(std::string_view text, const std::string& name);

/// How far two points are from each other.
///
/// Example: distance({0, 0, 1}, {3, 4, 1}) == 5
double distance(const std::array<double, 3>& a, const std::array<double, 3>& b);

/// The box around the points, as a range for each column; its longest side.
///
/// Throws Error if all points are the same.
double longest_side(const PointSet& points);

/// The cell of each point, in its order, in one grid of cells that are intervals, squares or cubes,
/// the longest side divided by 2^(count - 1) wide; the grid is moved by shares of the longest side.
/// Bits of the coordinates in turns: `code >> columns` is the cell twice as wide. At most 20 scales.
///
/// Throws Error if all points are the same or there are too many scales, Interrupted.
std::vector<std::uint64_t> cell_codes(const PointSet& points, std::size_t count,
                                      const std::array<double, 3>& shares, const Budget& budget);

/// The first `count` places of grids for points, in shares: those of `even_offsets` and a third one.
std::vector<std::array<double, 3>> even_places(std::size_t count);

/// Counts the cells (half-open, as those of Grid) that hold a point, for `count` dyadic scales from
/// the longest side downward and so many offsets of the grid. Cells are intervals, squares or cubes.
/// `parts` is the number of different points. O(points * log(points) * offsets) time, 32 bytes a
/// point; at most 20 scales.
///
/// Throws Error if all points are the same or there are too many scales, BoundReached, Interrupted.
BoxCounts box_counts(const PointSet& points, std::size_t count, std::size_t offsets,
                     const Budget& budget);

}  // namespace algae
