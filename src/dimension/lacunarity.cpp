#include <algorithm>
#include <bit>

#include "dimension/detail/cells.hpp"
#include "dimension/detail/measures.hpp"

// Lacunarity (Allain and Cloitre 1991): how unevenly the gaps of a set are distributed, by a box
// that glides over it.
//
// With M the number of filled cells in a box, lacunarity is the mean of M^2 over the square of the
// mean of M, over all places of the box. A table of sums over rectangles from the corner gives M
// with three additions, whatever the box; sums of squares are exact, in 128 bits, so that a set
// that fills all boxes alike has the lacunarity 1 exactly.
//
// For a self-similar set it falls as side^(D - space), so log lacunarity + space * log side is
// fitted as the other measures are. Figures are put into the square around them by walking along
// segments; points into the rectangle around them.

namespace algae {

namespace {

__extension__ using Wide = unsigned __int128;
constexpr std::size_t most_halvings = 11;
constexpr std::size_t most_pixels = std::size_t{1} << 31;  // so that counts fit 32 bits

/// How many cells are filled left of and below each corner.
std::vector<std::uint32_t> filled_before(const CellRectangle& cells, const Budget& budget) {
    if (cells.filled.size() != cells.columns * cells.rows || cells.filled.size() > most_pixels)
        throw Error("expected a rectangle of at most 2^31 cells, found " +
                    std::to_string(cells.filled.size()) + " cells for " +
                    std::to_string(cells.columns) + " columns and " + std::to_string(cells.rows) +
                    " rows");
    const std::size_t width = cells.columns + 1;
    budget.check_memory(width * (cells.rows + 1) * sizeof(std::uint32_t), "the sums over cells");
    std::vector<std::uint32_t> sums(width * (cells.rows + 1));
    for (std::size_t row = 0; row < cells.rows; ++row) {
        std::uint32_t here = 0;
        for (std::size_t column = 0; column < cells.columns; ++column) {
            here += cells.filled[row * cells.columns + column] ? 1 : 0;
            sums[(row + 1) * width + column + 1] = sums[row * width + column + 1] + here;
        }
    }
    if (sums.back() == 0) throw Error("no cell is filled: expected something to measure");
    return sums;
}

double of_side(const CellRectangle& cells, const std::vector<std::uint32_t>& sums, std::size_t side,
               const Budget& budget) {
    const std::size_t height = cells.rows == 1 ? 1 : side, width = cells.columns + 1;
    if (side == 0 || side > cells.columns || height > cells.rows)
        throw Error(
            "expected boxes of 1 to " +
            std::to_string(cells.rows == 1 ? cells.columns : std::min(cells.columns, cells.rows)) +
            " cells, found " + std::to_string(side));
    Wide sum = 0, squares = 0;
    for (std::size_t row = 0; row + height <= cells.rows; ++row) {
        budget.check();
        const std::uint32_t *low = &sums[row * width], *high = &sums[(row + height) * width];
        for (std::size_t column = 0; column + side <= cells.columns; ++column) {
            const std::uint64_t mass =
                high[column + side] - high[column] - low[column + side] + low[column];
            sum += mass;
            squares += mass * mass;
        }
    }
    const std::size_t places = (cells.columns - side + 1) * (cells.rows - height + 1);
    if (sum == 0) throw Error("no box holds a filled cell: expected something to measure");
    // The two are the same number where all boxes hold the same, and so is what they round to.
    return static_cast<double>(static_cast<long double>(squares * places) /
                               static_cast<long double>(sum * sum));
}

}  // namespace

std::vector<double> lacunarities(const CellRectangle& cells, std::span<const std::size_t> sides,
                                 const Budget& budget) {
    const std::vector<std::uint32_t> sums = filled_before(cells, budget);
    std::vector<double> all;
    for (const std::size_t side : sides) all.push_back(of_side(cells, sums, side, budget));
    return all;
}

Scaling lacunarity(const CellRectangle& cells, const Budget& budget) {
    const int space = cells.rows == 1 ? 1 : 2;
    const std::size_t shorter = space == 1 ? cells.columns : std::min(cells.columns, cells.rows);
    if (shorter == 0) throw Error("there are no cells: expected something to measure");
    std::vector<std::size_t> sides;
    for (std::size_t side = std::bit_floor(shorter); side > 0; side /= 2) sides.push_back(side);
    Scaling result;
    result.values = lacunarities(cells, sides, budget);
    std::vector<double> powers;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        result.sizes.push_back(static_cast<double>(sides[i]) * cells.cell);
        powers.push_back(std::log(result.values[i]) + space * std::log(result.sizes[i]));
    }
    ScaleRange range{ScaleRange::details * cells.cell,
                     static_cast<double>(shorter) * cells.cell / ScaleRange::parts_of_whole};
    range.scales = "boxes";
    range.finest_is = "4 cells";
    range.finer_ones_see = "single cells";
    fit_scaling(result, powers, range, {1, 1, 0}, space);
    return result;
}

CellRectangle drawn_cells(const Figure& figure, std::size_t most, const Budget& budget) {
    const Box& box = figure.box();
    const double whole = scales_of(box, 2, 1).coarsest;
    const auto details = static_cast<std::size_t>(
        std::clamp(std::floor(whole / figure.facts().step * (1 + 1e-9)), 1.0,
                   static_cast<double>(std::max<std::size_t>(most, 1))));
    CellRectangle cells;
    cells.cell = whole / static_cast<double>(details);
    cells.columns = cells.rows = details + 1;
    budget.check_memory(cells.columns * cells.rows / 8, "the cells of a grid");
    cells.filled.resize(cells.columns * cells.rows);
    const double half = (whole + cells.cell) / 2;
    const Grid grid{{(box.low.x + box.high.x) / 2 - half, (box.low.y + box.high.y) / 2 - half},
                    cells.cell};
    DrawnSegments canvas([&](Point start, Point end, bool) {
        const GridPoint from = grid.at(start), to = grid.at(end);
        std::int64_t column = from.column(), row = from.row();
        const auto mark = [&] {
            const auto at =
                static_cast<std::size_t>(row) * cells.columns + static_cast<std::size_t>(column);
            if (column < 0 || row < 0 || at >= cells.filled.size())
                throw Error("expected all points of the figure to lie within its box");
            cells.filled[at] = true;
        };
        mark();
        walk_cells(from, to, [&](const Crossing& crossing) {
            if (crossing.sideways) column += to.x > from.x ? 1 : -1;
            if (crossing.upright) row += to.y > from.y ? 1 : -1;
            mark();
        });
    });
    figure.draw(canvas, 0, budget);
    return cells;
}

CellRectangle filled_cells(const PointSet& points, const Budget& budget) {
    if (points.columns > 2)
        throw Error("lacunarity is measured on the line and in the plane, found points with " +
                    std::to_string(points.columns) + " columns");
    const double whole = longest_side(points);
    CellRectangle cells;
    cells.cell = points.detail;
    if (!(cells.cell > 0)) {
        const BoxCounts counts = box_counts(points, most_halvings, 1, budget);
        std::size_t scale = 0;
        while (scale + 1 < most_halvings && counts.mean(scale + 1) * ScaleRange::points_in_cell <=
                                                static_cast<double>(counts.parts))
            ++scale;
        cells.cell = counts.scales.cell(scale);
    }
    std::array<double, 2> low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
    for (const auto& point : points.points)
        for (std::size_t i = 0; i < 2; ++i) {
            low[i] = std::min(low[i], point[i]);
            high[i] = std::max(high[i], point[i]);
        }
    // Points without a size lie in the middle of a square, as figures do.
    if (!(points.detail > 0) && points.columns == 2)
        for (std::size_t i = 0; i < 2; ++i) low[i] = (low[i] + high[i] - whole) / 2;
    const auto place = [&](double at, double from) {
        return static_cast<std::size_t>(std::floor((at - from) / cells.cell + 0.5));
    };
    const bool square = !(points.detail > 0);
    cells.columns = place(square ? low[0] + whole : high[0], low[0]) + 1;
    cells.rows = points.columns == 1 ? 1 : place(square ? low[1] + whole : high[1], low[1]) + 1;
    budget.check_memory(cells.columns * cells.rows / 8, "the cells of a grid");
    cells.filled.resize(cells.columns * cells.rows);
    for (const auto& point : points.points)
        cells.filled[place(point[1], low[1]) * cells.columns + place(point[0], low[0])] = true;
    return cells;
}

}  // namespace algae
