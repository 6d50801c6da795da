#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "exact/exact.hpp"
#include "render/detail/figure_text.hpp"

using namespace algae;

namespace {

constexpr double side = 40;  // of the cell, in points

Cell cell() {
    Cell found;
    found.width = found.height = side;
    found.frame = Frame{1, 0, side};  // y upward, a unit is a point
    return found;
}

FigurePath polygon(std::uint32_t style, std::vector<Point> corners) {
    return {style, true, std::move(corners), {}};
}

FigurePath square(std::uint32_t style, double low, double high) {
    return polygon(style, {{low, low}, {high, low}, {high, high}, {low, high}});
}

FigurePaths figure_of(std::vector<FigurePath> paths) {
    FigurePaths found;
    found.paths = std::move(paths);
    for (const FigurePath& path : found.paths) {
        PathStyle style;
        style.width = 1 + path.style % 3;
        found.styles.push_back(style);
        if (path.filled)
            ++found.polygons;
        else
            found.strokes += path.points.size() - 1;
    }
    return found;
}

std::vector<std::uint32_t> styles_left(FigurePaths figure) {
    leave_out_hidden(figure, cell(), {});
    std::vector<std::uint32_t> left;
    for (const FigurePath& path : figure.paths) left.push_back(path.style);
    return left;
}

/// Whether a convex polygon or a stroke of this width covers a point, by its sides alone.
bool covers(const FigurePath& path, double width, const Point& at) {
    bool left = true, right = true;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const Point &a = path.points[i], &b = path.points[(i + 1) % path.points.size()];
        const double turn = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
        left = left && turn >= 0;
        right = right && turn <= 0;
        if (path.filled || i + 1 == path.points.size()) continue;
        const double long2 = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
        const double share =
            long2 > 0
                ? std::clamp(((at.x - a.x) * (b.x - a.x) + (at.y - a.y) * (b.y - a.y)) / long2, 0.0,
                             1.0)
                : 0;
        if (std::hypot(a.x + share * (b.x - a.x) - at.x, a.y + share * (b.y - a.y) - at.y) <=
            width / 2)
            return true;
    }
    return path.filled && (left || right);
}

/// The style on top at a point, or -1.
int on_top(const FigurePaths& figure, const Point& at) {
    for (auto path = figure.paths.rbegin(); path != figure.paths.rend(); ++path)
        if (covers(*path, figure.styles[path->style].width, at))
            return static_cast<int>(path->style);
    return -1;
}

}  // namespace

TEST_CASE("a path behind another is left out, one that looks out is kept") {
    using Styles = std::vector<std::uint32_t>;
    CHECK(styles_left(figure_of({square(0, 10, 20), square(1, 9, 21)})) == Styles{1});
    CHECK(styles_left(figure_of({square(0, 10, 20), square(1, 9, 19.5)})) == Styles{0, 1});
    CHECK(styles_left(figure_of({square(0, 9, 21), square(1, 10, 20)})) == Styles{0, 1});
    // A stroke behind a square, and one beside it.
    CHECK(styles_left(figure_of({{0, false, {{11, 11}, {19, 19}}, {}}, square(1, 9, 21)})) ==
          Styles{1});
    CHECK(styles_left(figure_of({{0, false, {{11, 11}, {23, 19}}, {}}, square(1, 9, 21)})) ==
          Styles{0, 1});
    // What reaches out of the cell is kept, and what is nowhere too.
    CHECK(styles_left(figure_of({square(0, -1, 1), square(1, -2, 2)})) == Styles{0, 1});
    CHECK(styles_left(figure_of({polygon(0, {{NAN, 1}, {2, 2}, {3, 1}}), square(1, 0, 9)})) ==
          Styles{0, 1});
    FigurePaths counted = figure_of(
        {{0, false, {{11, 11}, {15, 19}, {19, 11}}, {}}, square(1, 10, 20), square(2, 9, 21)});
    leave_out_hidden(counted, cell(), {});
    CHECK(counted.strokes == 0);
    CHECK(counted.polygons == 1);
}

TEST_CASE("what is on top at a point stays on top there when hidden paths are left out") {
    std::size_t left_out = 0, compared = 0;
    CHECK(rc::check([&] {
        const auto seed = *rc::gen::arbitrary<std::uint32_t>();
        std::mt19937 random(seed);
        const auto number = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        std::vector<FigurePath> paths;
        const auto count = static_cast<std::uint32_t>(number(2, 14));
        for (std::uint32_t i = 0; i < count; ++i) {
            const Point middle{number(8, 32), number(8, 32)};
            const double reach = number(0.2, 2 + i);  // later ones hide more
            FigurePath& path = paths.emplace_back();
            path.style = i;
            path.filled = number(0, 1) < 0.7;
            double turn = number(0, 6);
            const int corners = path.filled ? static_cast<int>(number(3, 6)) : 2;
            for (int k = 0; k < corners; ++k) {  // on a circle, so that they are convex
                path.points.push_back(
                    {middle.x + reach * std::cos(turn), middle.y + reach * std::sin(turn)});
                turn += 6.283185307179586 / corners;
            }
        }
        const FigurePaths all = figure_of(paths);
        FigurePaths some = all;
        leave_out_hidden(some, cell(), {});
        left_out += all.paths.size() - some.paths.size();
        for (int i = 0; i < 400; ++i) {
            const Point at{number(0, side), number(0, side)};
            ++compared;
            RC_ASSERT(on_top(all, at) == on_top(some, at));
        }
    }));
    CHECK(left_out > 10);
    CHECK(compared > 10'000);
    MESSAGE("points compared: " << compared << ", paths left out: " << left_out);
}
