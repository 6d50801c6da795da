#include <algorithm>
#include <cmath>

#include "nature/detail/checks.hpp"
#include "nature/detail/height_field.hpp"
#include "watch/watch.hpp"

// Random surfaces over a square, and the lines on which they have a height.
//
// `diamond_square` displaces midpoints of squares in two half steps a level (Fournier, Fussell and
// Carpenter 1982): centres from four corners, then middles of edges from the two to four points
// around. It leaves creases along the first squares (Miller 1986).
//
// `exact_surface` has the distribution of fractional Brownian motion of the plane (Stein 2002): a
// periodic field whose covariance, up to the distance needed, is that of the surface less a
// parabola, made by the Fourier transform; and a random slope, whose variance makes up for the
// parabola. For 2H > 1.5 the covariance must be continued beyond the distance 1 so that it stays
// positive definite, which doubles the period.
//
// Contour lines are found by marching squares. On each edge of the grid whose ends are below and
// not below the height lies one point, in proportion; within a square the points are joined so that
// what is not below lies to the left, and where there are two ways, as the mean of the corners
// says. Each edge then has at most one line that comes and one that goes, so that lines are lists
// linked by edges: first those that begin at the border are followed, then closed ones.

namespace algae {

namespace {

/// The covariance of the periodic field at a distance, in units in which the surface's diagonal is
/// at most 1; it is 0 from `range` on (Stein 2002, formulas 5 to 9).
class Embedding {
public:
    explicit Embedding(double hurst) : exponent_(2 * hurst) {
        if (exponent_ <= 1.5) {
            parabola = exponent_ / 2;
            constant_ = 1 - exponent_ / 2;
            return;
        }
        range = 2;
        tail_ = exponent_ * (2 - exponent_) / (3 * range * (range * range - 1));
        parabola = (exponent_ - tail_ * (range - 1) * (range - 1) * (range + 2)) / 2;
        constant_ = tail_ * std::pow(range - 1, 3) + 1 - parabola;
    }
    double operator()(double distance) const {
        if (distance <= 1)
            return constant_ - std::pow(distance, exponent_) + parabola * distance * distance;
        return distance < range ? tail_ * std::pow(range - distance, 3) / distance : 0;
    }

    double range = 1, parabola = 0;

private:
    double exponent_, tail_ = 0, constant_ = 0;
};

}  // namespace

void check_surface(const BrownianMotion& surface) {
    check_parameters(surface);
    require(surface.levels <= most_surface_levels,
            "levels: expected 0 to {} for a surface, found {}",
            {most_surface_levels, surface.levels});
}

HeightField diamond_square(const BrownianMotion& surface, const Gaussians& numbers,
                           const Budget& budget) {
    check_surface(surface);
    const std::size_t squares = std::size_t{1} << surface.levels, last = squares;
    HeightField field{squares + 1, {}};
    budget.check_memory(field.side * field.side * sizeof(double), "a surface");
    field.heights.resize(field.side * field.side);
    std::uint64_t number = 0;
    for (const std::size_t row : {std::size_t{0}, last})
        for (const std::size_t column : {std::size_t{0}, last})
            field.at(column, row) = surface.sigma * numbers.at(number++);
    const auto deviation = [&](int half_step) {
        return surface.sigma * std::sqrt(std::exp2(-surface.hurst * half_step) *
                                         (1 - std::exp2(2 * surface.hurst - 2)));
    };
    WorkCount levels("level", static_cast<std::uint64_t>(surface.levels));
    for (int level = 1; level <= surface.levels; ++level) {
        ++levels;
        const std::size_t half = squares >> level, edge = 2 * half;
        const double of_centres = deviation(2 * level - 1), of_edges = deviation(2 * level);
        for (std::size_t row = half; row < last; row += edge) {
            budget.check();
            for (std::size_t column = half; column < last; column += edge)
                field.at(column, row) =
                    (field.at(column - half, row - half) + field.at(column + half, row - half) +
                     field.at(column - half, row + half) + field.at(column + half, row + half)) /
                        4 +
                    of_centres * numbers.at(number++);
        }
        for (std::size_t row = 0; row <= last; row += half) {
            budget.check();
            for (std::size_t column = row / half % 2 == 0 ? half : 0; column <= last;
                 column += edge) {
                double sum = 0;
                int around = 0;
                const auto add = [&](std::size_t x, std::size_t y) {
                    sum += field.at(x, y);
                    ++around;
                };
                if (column >= half) add(column - half, row);
                if (column + half <= last) add(column + half, row);
                if (row >= half) add(column, row - half);
                if (row + half <= last) add(column, row + half);
                field.at(column, row) = sum / around + of_edges * numbers.at(number++);
            }
        }
    }
    return field;
}

HeightField exact_surface(const BrownianMotion& surface, const Gaussians& numbers,
                          const Budget& budget) {
    check_surface(surface);
    const Embedding covariance(surface.hurst);
    const std::size_t squares = std::size_t{1} << surface.levels;
    // The surface has the edge 1/2 here, so that its diagonal is below 1.
    const std::size_t period = squares * (covariance.range > 1 ? 8 : 4);
    const double spacing = 0.5 / static_cast<double>(squares);
    budget.check_memory(period * period * sizeof(std::complex<double>), "a surface");
    std::vector<std::complex<double>> values(period * period);
    const auto around = [&](std::size_t i) {
        return spacing * static_cast<double>(std::min(i, period - i));
    };
    WorkCount rows("row of covariances", period);
    for (std::size_t row = 0; row < period; ++row) {
        budget.check();
        rows.at(row);
        for (std::size_t column = 0; column < period; ++column)
            values[row * period + column] = covariance(std::hypot(around(column), around(row)));
    }
    fourier_transform_square(values, period);
    budget.check();
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double share = std::max(values[i].real(), 0.0) / static_cast<double>(values.size());
        values[i] = std::sqrt(share) * std::complex(numbers.at(2 * i + 2), numbers.at(2 * i + 3));
    }
    budget.check();
    fourier_transform_square(values, period);
    HeightField field{squares + 1, {}};
    field.heights.resize(field.side * field.side);
    // var(X(p) - X(q)) is 2 |p - q|^(2H) here, and lengths are half of those wanted.
    const double scale = surface.sigma * std::sqrt(std::exp2(2 * surface.hurst) / 2);
    const double slope = std::sqrt(2 * covariance.parabola) * spacing;
    for (std::size_t row = 0; row < field.side; ++row)
        for (std::size_t column = 0; column < field.side; ++column)
            field.at(column, row) =
                scale * (values[row * period + column].real() - values[0].real() +
                         slope * (static_cast<double>(column) * numbers.at(0) +
                                  static_cast<double>(row) * numbers.at(1)));
    return field;
}

double height_at_share(const HeightField& field, double share) {
    require(share >= 0 && share <= 1 && !field.heights.empty(),
            "expected a share from 0 to 1 of a surface, found {}", {share});
    std::vector<double> sorted = field.heights;
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
    return sorted[static_cast<std::size_t>(place)];
}

namespace {

using Edge = std::uint32_t;
constexpr Edge none = std::numeric_limits<Edge>::max();

/// For each set of corners that are not below the height (bits 0 to 3: lower left, lower right,
/// upper right, upper left), the sides at which the line enters a square and leaves it, with these
/// corners to its left: 0 is the lower side, 1 the right, 2 the upper, 3 the left one.
constexpr std::size_t ways[16][2] = {{},     {0, 3}, {1, 0}, {1, 3}, {2, 1}, {},     {2, 0}, {2, 3},
                                     {3, 2}, {0, 2}, {},     {1, 2}, {3, 1}, {0, 1}, {3, 0}, {}};

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
            const bool middle = (a + b + c + d) / 4 >= height;  // decides where there are two ways
            if (high == 5) {
                join(below, middle ? right : left);
                join(above, middle ? left : right);
            } else if (high == 10) {
                join(left, middle ? below : above);
                join(right, middle ? above : below);
            } else {
                const std::array<Edge, 4> sides{below, right, above, left};
                join(sides[ways[high][0]], sides[ways[high][1]]);
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
