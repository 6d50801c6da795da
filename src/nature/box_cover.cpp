#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "nature/detail/figures.hpp"
#include "nature/detail/height_field.hpp"

// Box counting as a picture: some sets, the squares of a grid that they touch, and their numbers as
// a plot.
//
// Sets are a segment, a square, Koch's curve in 8 steps and the coast of a random island, on heights made by displacing midpoints
// with H = 3/4, where the dimension tends to 5/4, as Richardson measured it in Britain; all are moved and scaled so that the
// longest side is 1. A square is counted if one of many points along
// the lines lies in it; points on the upper or right end of the whole belong to the square before.
// Koch's curve can also be covered with squares that turn with its copies, three for each.
//
// The plot shows log N against log 1/m with the line of least squares. Better estimates, with
// intervals, are those of dimension.hpp.

namespace algae {

namespace {

constexpr int koch_steps = 8, coast_levels = 9;

Stroke koch(int steps) {
    Stroke curve{{0, 0}, {1, 0}};
    for (int step = 0; step < steps; ++step) {
        Stroke finer{curve.front()};
        for (std::size_t i = 1; i < curve.size(); ++i) {
            const Point a = curve[i - 1], b = curve[i];
            const double x = (b.x - a.x) / 3, y = (b.y - a.y) / 3, h = std::sqrt(3) / 2;
            finer.push_back({a.x + x, a.y + y});
            finer.push_back({a.x + 1.5 * x - h * y, a.y + 1.5 * y + h * x});
            finer.push_back({a.x + 2 * x, a.y + 2 * y});
            finer.push_back(b);
        }
        curve = std::move(finer);
    }
    return curve;
}

/// The longest closed coast of an island, which the sea surrounds.
Stroke island(std::uint64_t seed, const Budget& budget) {
    HeightField field = diamond_square({0.75, 1, coast_levels}, Gaussians(seed, 0), budget);
    for (std::size_t row = 0; row < field.side; ++row)
        for (std::size_t column = 0; column < field.side; ++column) {
            const double x = 2 * field.spacing() * static_cast<double>(column) - 1;
            const double y = 2 * field.spacing() * static_cast<double>(row) - 1;
            // Higher than wide, and the border under water.
            const double r = 2.2 * x * x + 1.2 * y * y;
            field.at(column, row) -= 0.45 * r * r;
        }
    std::vector<Stroke> lines = contour_lines(field, height_at_share(field, 0.72), budget);
    std::erase_if(lines, [](const Stroke& line) { return !(line.front() == line.back()); });
    if (lines.empty()) throw Error("there is no coast with this seed");
    return *std::max_element(lines.begin(), lines.end(),
                             [](const Stroke& a, const Stroke& b) { return a.size() < b.size(); });
}

/// Moved and scaled so that the lower left corner is (0, 0) and the longer side 1.
void fit(std::vector<Stroke>& strokes) {
    Box box;
    for (const Stroke& stroke : strokes)
        for (const Point& point : stroke) box.add(point);
    const double scale = 1 / std::max(box.breadth(), box.height());
    for (Stroke& stroke : strokes)
        for (Point& point : stroke)
            point = {(point.x - box.low.x) * scale, (point.y - box.low.y) * scale};
}

Path filled_square(const BoxCover::Square& square, const Colour& paint) {
    const auto [corner, edge] = square;
    return {.points = {corner,
                       {corner.x + edge.x, corner.y + edge.y},
                       {corner.x + edge.x - edge.y, corner.y + edge.y + edge.x},
                       {corner.x - edge.y, corner.y + edge.x}},
            .filled = true,
            .paint = paint};
}

Path outline(const BoxCover::Square& square, const Colour& paint) {
    Path path = filled_square(square, paint);
    path.filled = false;
    path.points.push_back(square.corner);
    path.width = 0.7;
    return path;
}

/// Three squares along the base of every copy of Koch's curve, a third as wide.
std::vector<BoxCover::Square> turned_squares(double side) {
    int steps = 0;
    while (steps < koch_steps && std::pow(3.0, -steps - 1) > 1.001 * side) ++steps;
    require(std::fabs(side * std::pow(3.0, steps + 1) - 1) <= 1e-6,
            "cells: turned squares have the sides 1/3, 1/9, ... 1/6561, found {}", {side});
    const Stroke bases = koch(steps);
    std::vector<BoxCover::Square> squares;
    for (std::size_t i = 1; i < bases.size(); ++i) {
        const Point edge{(bases[i].x - bases[i - 1].x) / 3, (bases[i].y - bases[i - 1].y) / 3};
        for (int k = 0; k < 3; ++k)
            squares.push_back({{bases[i - 1].x + k * edge.x, bases[i - 1].y + k * edge.y}, edge});
    }
    return squares;
}

/// Of the shapes in their order.
constexpr const char* shape_names[] = {"segment", "square", "koch", "coast"};

}  // namespace

void BoxCover::check() const {
    require(!cells.empty(), "cells: expected at least one side");
    for (const double side : cells)
        require(side <= 1 && side >= 1.0 / 4096, "cells: expected sides from 1/4096 to 1, found {}",
                {side});
    require(!turned || shape == Shape::koch,
            "squares turned: expected set koch, whose copies turn");
    require(!plot || cells.size() >= 2, "cells: expected at least two sides for a plot");
}

std::vector<Stroke> BoxCover::strokes(const Budget& budget) const {
    std::vector<Stroke> made;
    switch (shape) {
        case Shape::segment:
            return {{{0, 0}, {1, 0}}};
        case Shape::square:
            return {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
        case Shape::koch:
            made = {koch(koch_steps)};
            break;
        default:
            made = {island(seed, budget)};
            break;
    }
    fit(made);
    return made;
}

std::vector<BoxCover::Square> BoxCover::covering(double side, const Budget& budget) const {
    if (turned) return turned_squares(side);
    const auto cells_of_one = static_cast<std::int64_t>(std::ceil(1 / side - 1e-9));
    std::set<std::pair<std::int64_t, std::int64_t>> touched;
    if (shape == Shape::square) {
        for (std::int64_t y = 0; y < cells_of_one; ++y)
            for (std::int64_t x = 0; x < cells_of_one; ++x) touched.insert({x, y});
    } else {
        // Points close enough together that hardly a corner of a square is cut unseen.
        const double step = side / 64;
        for (const Stroke& stroke : strokes(budget))
            for (std::size_t i = 1; i < stroke.size(); ++i) {
                if (i % 256 == 0) budget.check();
                const Point a = stroke[i - 1], b = stroke[i];
                const int parts = 1 + static_cast<int>(distance(a, b) / step);
                for (int k = 0; k <= parts; ++k) {
                    const double share = static_cast<double>(k) / parts;
                    const auto cell = [&](double from, double to) {
                        const double at = (from + share * (to - from)) / side;
                        return std::min(static_cast<std::int64_t>(std::floor(at + 1e-9)),
                                        cells_of_one - 1);
                    };
                    touched.insert({cell(a.x, b.x), cell(a.y, b.y)});
                }
            }
    }
    std::vector<Square> squares;
    for (const auto& [x, y] : touched)
        squares.push_back(
            {{side * static_cast<double>(x), side * static_cast<double>(y)}, {side, 0}});
    return squares;
}

std::vector<GeneratorFigure> BoxCover::figures(const Budget& budget) const {
    check();
    const std::vector<Stroke> lines = strokes(budget);
    std::vector<GeneratorFigure> made;
    const Colour ink{0.12, 0.23, 0.37}, box{0.86, 0.91, 0.96}, edge{0.55, 0.66, 0.78};
    std::vector<Point> counts;
    for (const double side : cells) {
        const std::vector<Square> squares = covering(side, budget);
        counts.push_back({-std::log10(side), std::log10(static_cast<double>(squares.size()))});
        if (plot) continue;
        std::vector<Path> paths;
        for (const Square& square : squares) paths.push_back(filled_square(square, box));
        for (const Square& square : squares) paths.push_back(outline(square, edge));
        const bool plain = shape == Shape::segment || shape == Shape::square;
        for (const Stroke& line : lines)
            paths.push_back({.points = line, .width = plain ? 2 : 0.9, .paint = ink});
        const bool is_part = 1 / side == std::round(1 / side) && side < 1;
        made.push_back(pictured(
            *this, std::move(paths),
            fmt::format("m = {}, N = {}",
                        is_part ? fmt::format("1/{:g}", 1 / side) : fmt::format("{:.4g}", side),
                        squares.size())));
    }
    if (!plot) return made;
    const auto [slope, height, is_level] = best_line(counts);
    Point high{0, 0};
    for (const Point& count : counts) {
        high.x = std::max(high.x, count.x * 1.08 + 0.05);
        high.y = std::max(high.y, count.y * 1.08 + 0.05);
    }
    std::vector<Path> paths;
    const auto line = [&](Point from, Point to, const Colour& paint, double width) {
        paths.push_back({.points = {from, to}, .width = width, .paint = paint});
    };
    const double tick = 0.015 * high.x;
    line({0, 0}, {high.x, 0}, {0, 0, 0}, 1);
    line({0, 0}, {0, high.y}, {0, 0, 0}, 1);
    for (int k = 1; 0.5 * k < high.x; ++k) line({0.5 * k, 0}, {0.5 * k, -tick}, {0, 0, 0}, 1);
    for (int k = 1; 0.5 * k < high.y; ++k) line({0, 0.5 * k}, {-tick, 0.5 * k}, {0, 0, 0}, 1);
    line({0, height}, {high.x, height + slope * high.x}, {0.75, 0.3, 0.2}, 1.2);
    for (const Point& count : counts)
        paths.push_back(filled_square({{count.x - tick, count.y - tick}, {2 * tick, 0}}, ink));
    made.push_back(
        pictured(*this, std::move(paths),
                 fmt::format("log N(m) against log 1/m, marks each 0.5: slope {:.4f}, log k {:.4f}",
                             slope, height)));
    return made;
}

GeneratorFigure BoxCover::measured_figure(const Budget& budget) const {
    std::vector<Path> paths;
    for (Stroke& stroke : strokes(budget)) paths.push_back({.points = std::move(stroke)});
    return {std::make_unique<PathFigure>(std::move(paths), style), heading(), ""};
}

std::vector<GeneratorFact> BoxCover::facts(const Budget& budget) const {
    check();
    std::vector<GeneratorFact> found;
    const char* const set = shape_names[static_cast<std::size_t>(shape)];
    found.push_back({"set", set, set});
    std::vector<Point> logarithms;
    std::string text;
    nlohmann::ordered_json counts = nlohmann::ordered_json::array();
    for (const double side : cells) {
        const std::size_t count = covering(side, budget).size();
        text += fmt::format("{}N({:.4g}) = {}", text.empty() ? "" : ", ", side, count);
        counts.push_back({{"side", side}, {"boxes", count}});
        logarithms.push_back({-std::log10(side), std::log10(static_cast<double>(count))});
    }
    found.push_back({"boxes", text, counts});
    if (cells.size() > 1) {
        const double slope = best_line(logarithms).slope;
        found.push_back({"slope", fmt::format("{:.6f}", slope), slope});
    }
    return found;
}

}  // namespace algae
