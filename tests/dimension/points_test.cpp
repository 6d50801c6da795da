#include "dimension/dimension.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <set>

#include "exact/exact.hpp"

using namespace algae;

namespace {

/// The cells that hold points, by asking a set of triples.
std::size_t cells_of(const PointSet& set, double cell, const std::array<double, 3>& origin) {
    std::set<std::array<long, 3>> cells;
    for (const auto& point : set.points) {
        std::array<long, 3> index{};
        for (std::size_t i = 0; i < 3; ++i)
            index[i] = std::lround(
                std::floor(std::floor((point[i] - origin[i]) / cell * 0x1p20 + 0.5) / 0x1p20));
        cells.insert(index);
    }
    return cells.size();
}

}  // namespace

TEST_CASE("cells with points in them, on every scale") {
    CHECK(rc::check("points", [] {
        PointSet set;
        set.columns = *rc::gen::inRange(1, 4);
        const auto coordinate =
            rc::gen::map(rc::gen::inRange(0, 65), [](int k) { return k / 8.0; });
        const auto some = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::array<double, 3>>>(
            rc::gen::container<std::array<double, 3>>(coordinate)));
        for (auto point : some) {
            for (int i = set.columns; i < 3; ++i) point[static_cast<std::size_t>(i)] = 0;
            set.points.push_back(point);
        }
        set.points.push_back({-1, 0, 0});  // at least two different points
        const BoxCounts counts = box_counts(set, 6, 2, Budget());
        std::array<double, 3> low{1e9, 1e9, 1e9};
        for (const auto& point : set.points)
            for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], point[i]);
        const auto offsets = even_offsets(2);
        const double side = longest_side(set);
        for (std::size_t k = 0; k < 2; ++k) {
            const std::array<double, 3> origin{
                low[0] - offsets[k].x * side, low[1] - offsets[k].y * side,
                low[2] - std::fmod(0.6180339887498949 * static_cast<double>(k + 1), 1) * side};
            // Exact decisions are for cells a fraction of the finest one; lattice and offsets keep away from borders.
            for (std::size_t scale = 0; scale < 6; ++scale)
                RC_ASSERT(counts.counts[scale][k] ==
                          cells_of(set, counts.scales.cell(scale), origin));
        }
        const std::set<std::array<double, 3>> different(set.points.begin(), set.points.end());
        RC_ASSERT(counts.parts == different.size());
    }));
}

TEST_CASE("points are read from text with commas or white space") {
    CHECK(read_points("1,2\n3;4\n 5\t6 \n\n# a remark\n7 8 # another\r\n", "p").points.size() == 4);
    CHECK(read_points("x;y;z\n+1, -2.5 ,3e2", "p").points ==
          std::vector<std::array<double, 3>>{{1, -2.5, 300}});
    CHECK(read_points("0.25\n0.5\n", "p").columns == 1);
}

TEST_CASE("text that holds no points is refused with line and column") {
    const auto message = [](const char* text) {
        try {
            read_points(text, "p.csv");
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(message("1 2\n3 x\n") == "p.csv:2:3: error: expected a number, found 'x'\n  3 x\n    ^");
    CHECK(message("1,2\n3,,4\n").starts_with("p.csv:2:3: error: expected a number, found nothing"));
    CHECK(message("1,2\n3,\n").starts_with("p.csv:2:3: error: expected a number, found nothing"));
    CHECK(message("1 2\n3 4 5\n")
              .starts_with("p.csv:2:5: error: expected 2 columns as in line 1, found 3"));
    CHECK(message("1 2 3 4\n").starts_with("p.csv:1:7: error: expected 1 to 3 columns, found 4"));
    CHECK(message("1 nan\n").starts_with("p.csv:1:3: error: expected a number, found 'nan'"));
    CHECK(message("1 1e999\n").starts_with("p.csv:1:3: error: expected a number, found '1e999'"));
    CHECK(message("x y\n") == "p.csv: expected points, one a line, found none");
    CHECK(message("") == "p.csv: expected points, one a line, found none");
}

TEST_CASE("points that cannot be measured are refused") {
    PointSet same{2, {{1, 2, 0}, {1, 2, 0}}, 0, "point"};
    CHECK_THROWS_WITH_AS(box_counts(same, 4, 1, Budget()),
                         "all points are the same: expected something to measure", Error);
    CHECK_THROWS_WITH_AS(longest_side(PointSet{}),
                         "there are no points: expected something to measure", Error);
    PointSet two{1, {{0, 0, 0}, {1, 0, 0}}, 0, "point"};
    CHECK_THROWS_WITH_AS(box_counts(two, 21, 1, Budget()),
                         "expected 1 to 20 scales and at least one offset, found 21 and 1", Error);
    Budget small;
    small.memory = 10;
    CHECK_THROWS_AS(box_counts(two, 4, 1, small), BoundReached);
}

TEST_CASE("points of a filled cube, a square and the Cantor set") {
    PointSet square{2, {}, 0, "point"}, cube{3, {}, 0, "point"}, cantor{1, {}, 0, "point"};
    for (int i = 0; i < 256; ++i)
        for (int j = 0; j < 256; ++j) square.points.push_back({i + 0.5, j + 0.5, 0});
    for (int i = 0; i < 1 << 17; ++i) {
        double x = 0;
        for (int bit = 0; bit < 17; ++bit)
            if (i >> bit & 1) x += 2 * std::pow(3, -1 - bit);
        cantor.points.push_back({x, 0, 0});
    }
    const auto holds = [](const PointSet& set, double truth) {
        const BoxFit fit = fit_dimension(box_counts(set, 16, 8, Budget()));
        REQUIRE(fit.estimate);
        CAPTURE(fit.because);
        CHECK(fit.estimate->low <= truth + 1e-9);
        CHECK(fit.estimate->high >= truth - 1e-9);
    };
    holds(square, 2);
    holds(cantor, std::log(2) / std::log(3));
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j)
            for (int k = 0; k < 64; ++k) cube.points.push_back({double(i), double(j), double(k)});
    const BoxFit fit = fit_dimension(box_counts(cube, 12, 2, Budget()));
    if (fit.estimate) CHECK(fit.estimate->high > 2.9);
}
