#include "nature/contour.hpp"

#include <cstdint>
#include <limits>

namespace algae {

namespace {

using Edge = std::uint32_t;
constexpr Edge none = std::numeric_limits<Edge>::max();

/// The edges of a grid: from each point one to the right and one upward.
class Edges {
public:
    Edges(const HeightField& field, double height) : field_(field), height_(height) {}

    Edge right_of(std::size_t column, std::size_t row) const {
        return static_cast<Edge>(2 * (row * field_.side + column));
    }
    Edge above(std::size_t column, std::size_t row) const { return right_of(column, row) + 1; }
    /// Where the surface has the height on an edge.
    Point crossing(Edge edge) const {
        const std::size_t point = edge / 2, column = point % field_.side, row = point / field_.side;
        const bool upward = edge % 2 == 1;
        const double from = field_.heights[point];
        const double to = field_.heights[point + (upward ? field_.side : 1)];
        const double share = (height_ - from) / (to - from);
        return {field_.spacing() * (static_cast<double>(column) + (upward ? 0 : share)),
                field_.spacing() * (static_cast<double>(row) + (upward ? share : 0))};
    }

private:
    const HeightField& field_;
    double height_;
};

}  // namespace

std::vector<Stroke> contour_lines(const HeightField& field, double height, const Budget& budget) {
    if (field.side < 2) return {};
    const std::size_t points = field.side * field.side;
    budget.check_memory(2 * points * (sizeof(Edge) + 1), "contour lines");
    const Edges edges(field, height);
    std::vector<Edge> next(2 * points, none);  // where the line goes on that comes to an edge
    std::vector<bool> entered(2 * points);     // whether a line comes to it from inside the grid
    const auto join = [&](Edge from, Edge to) {
        next[from] = to;
        entered[to] = true;
    };
    for (std::size_t row = 0; row + 1 < field.side; ++row) {
        budget.check();
        for (std::size_t column = 0; column + 1 < field.side; ++column) {
            const double a = field.at(column, row), b = field.at(column + 1, row);
            const double c = field.at(column + 1, row + 1), d = field.at(column, row + 1);
            const unsigned high = (a >= height ? 1u : 0u) | (b >= height ? 2u : 0u) |
                                  (c >= height ? 4u : 0u) | (d >= height ? 8u : 0u);
            if (high == 0 || high == 15) continue;
            const Edge below = edges.right_of(column, row), left = edges.above(column, row);
            const Edge above = edges.right_of(column, row + 1);
            const Edge right = edges.above(column + 1, row);
            switch (high) {  // with the high corners to the left
                case 1:
                    join(below, left);
                    break;
                case 2:
                    join(right, below);
                    break;
                case 3:
                    join(right, left);
                    break;
                case 4:
                    join(above, right);
                    break;
                case 6:
                    join(above, below);
                    break;
                case 7:
                    join(above, left);
                    break;
                case 8:
                    join(left, above);
                    break;
                case 9:
                    join(below, above);
                    break;
                case 11:
                    join(right, above);
                    break;
                case 12:
                    join(left, right);
                    break;
                case 13:
                    join(below, right);
                    break;
                case 14:
                    join(left, below);
                    break;
                case 5:
                    join(below, (a + b + c + d) / 4 >= height ? right : left);
                    join(above, (a + b + c + d) / 4 >= height ? left : right);
                    break;
                default:  // 10
                    join(left, (a + b + c + d) / 4 >= height ? below : above);
                    join(right, (a + b + c + d) / 4 >= height ? above : below);
            }
        }
    }
    std::vector<Stroke> lines;
    const auto follow = [&](Edge first) {
        Stroke line{edges.crossing(first)};
        Edge edge = first;
        while (next[edge] != none) {
            const Edge to = next[edge];
            next[edge] = none;
            edge = to;
            line.push_back(edges.crossing(edge));
        }
        lines.push_back(std::move(line));
    };
    for (Edge edge = 0; edge < next.size(); ++edge)  // those from border to border first
        if (next[edge] != none && !entered[edge]) follow(edge);
    for (Edge edge = 0; edge < next.size(); ++edge)
        if (next[edge] != none) follow(edge);
    return lines;
}

}  // namespace algae
