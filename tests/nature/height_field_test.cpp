#include "nature/detail/height_field.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "exact/exact.hpp"
#include "nature/detail/random.hpp"

using namespace algae;

TEST_CASE("the Fourier transform, against its sum") {
    CHECK(rc::check([] {
        const auto size = *rc::gen::inRange<std::size_t>(1, 40);
        std::vector<std::complex<double>> values;
        for (std::size_t i = 0; i < size; ++i)
            values.emplace_back(*rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10));
        const auto found = fourier_transform(values);
        for (std::size_t j = 0; j < size; ++j) {
            std::complex<double> sum = 0;
            for (std::size_t k = 0; k < size; ++k)
                sum += values[k] *
                       std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(j * k % size) /
                                           static_cast<double>(size));
            RC_ASSERT(std::abs(found[j] - sum) < 1e-9);
        }
    }));
    std::vector<std::complex<double>> square{1, 2, 3, 5};
    fourier_transform_square(square, 2);
    CHECK(square == std::vector<std::complex<double>>{11, -3, -5, 1});
}

TEST_CASE("a surface with fewer levels is the coarser version of the same surface") {
    const auto fine = diamond_square({0.6, 1, 6}, Gaussians(5, 0), {});
    const auto coarse = diamond_square({0.6, 1, 3}, Gaussians(5, 0), {});
    REQUIRE(fine.side == 65);
    for (std::size_t row = 0; row < 9; ++row)
        for (std::size_t column = 0; column < 9; ++column)
            CHECK(fine.at(8 * column, 8 * row) == coarse.at(column, row));
}

TEST_CASE("the displacements of squares have the variances of their half steps") {
    double centre = 0, edge = 0;
    const int count = 20'000;
    const BrownianMotion surface{0.7, 2, 1};
    for (int seed = 0; seed < count; ++seed) {
        const auto field =
            diamond_square(surface, Gaussians(static_cast<std::uint64_t>(seed), 0), {});
        const double middle =
            field.at(1, 1) -
            (field.at(0, 0) + field.at(2, 0) + field.at(0, 2) + field.at(2, 2)) / 4;
        const double side = field.at(1, 0) - (field.at(0, 0) + field.at(2, 0) + field.at(1, 1)) / 3;
        centre += middle * middle / count;
        edge += side * side / count;
    }
    const double share = 4 * (1 - std::pow(2, -0.6)), error = 5 * std::sqrt(2.0 / count);
    CHECK(std::abs(centre / (share * std::pow(2, -0.7)) - 1) < error);
    CHECK(std::abs(edge / displacement_variance(surface, 1) - 1) < error);
}

TEST_CASE("exact surfaces have the variances of fractional Brownian motion between all places") {
    for (const double hurst : {0.2, 0.5, 0.75, 0.9}) {
        const int count = 6000;
        const std::size_t places[][2] = {{0, 0}, {4, 0}, {0, 4}, {4, 4}, {1, 3}, {2, 1}};
        double squares[6][6] = {};
        for (int seed = 0; seed < count; ++seed) {
            const auto field =
                exact_surface({hurst, 1.5, 2}, Gaussians(static_cast<std::uint64_t>(seed), 0), {});
            for (int i = 0; i < 6; ++i)
                for (int j = 0; j < i; ++j) {
                    const double rise =
                        field.at(places[i][0], places[i][1]) - field.at(places[j][0], places[j][1]);
                    squares[i][j] += rise * rise / count;
                }
        }
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < i; ++j) {
                const double across =
                    (static_cast<double>(places[i][0]) - static_cast<double>(places[j][0])) / 4;
                const double along =
                    (static_cast<double>(places[i][1]) - static_cast<double>(places[j][1])) / 4;
                const double wanted = 2.25 * std::pow(std::hypot(across, along), 2 * hurst);
                CAPTURE(hurst);
                CAPTURE(i);
                CAPTURE(j);
                CHECK(std::abs(squares[i][j] / wanted - 1) < 5 * std::sqrt(2.0 / count));
            }
    }
}

TEST_CASE("the lines of an exact surface are as rough as its paths") {
    // Along a line, a fractional Brownian surface is a fractional Brownian path.
    double mean = 0;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const auto field = exact_surface({0.6, 1, 8}, Gaussians(seed, 0), {});
        for (std::size_t row = 0; row < field.side; row += 32) {
            const std::vector<double> line(
                field.heights.begin() + static_cast<std::ptrdiff_t>(row * field.side),
                field.heights.begin() + static_cast<std::ptrdiff_t>((row + 1) * field.side));
            mean += estimated_hurst(line) / 36;
        }
    }
    CHECK(std::abs(mean - 0.6) < 0.04);
}

TEST_CASE("the height at a share") {
    const HeightField field{2, {4, 1, 3, 2}};
    CHECK(height_at_share(field, 0) == 1);
    CHECK(height_at_share(field, 1) == 4);
    CHECK(height_at_share(field, 0.4) == 2);
    CHECK_THROWS_WITH_AS(height_at_share(field, 2),
                         "expected a share from 0 to 1 of a surface, found 2", Error);
}

TEST_CASE("surfaces out of range are refused") {
    CHECK_THROWS_WITH_AS(diamond_square({1.5, 1, 3}, Gaussians(1, 0), {}),
                         "hurst: expected a number between 0 and 1, found 1.5", Error);
    CHECK_THROWS_WITH_AS(exact_surface({0.5, 1, 14}, Gaussians(1, 0), {}),
                         "levels: expected 0 to 13 for a surface, found 14", Error);
    CHECK_THROWS_AS(exact_surface({0.9, 1, 13}, Gaussians(1, 0), {}), BoundReached);
}

TEST_CASE(
    "contour lines lie at their height, have the high side to their left, and end at the border") {
    CHECK(rc::check([] {
        const int levels = *rc::gen::inRange(0, 6);
        const auto field = diamond_square({0.5, 1, levels},
                                          Gaussians(*rc::gen::arbitrary<std::uint32_t>(), 0), {});
        const double height = *rc::gen::inRange(-20, 21) / 20.0;
        const double cells = static_cast<double>(field.side - 1);
        std::size_t points = 0;
        for (const Stroke& line : contour_lines(field, height, {})) {
            RC_ASSERT(line.size() >= 2);
            const bool closed = line.front() == line.back();
            const auto at_border = [](Point p) {
                return p.x == 0 || p.y == 0 || p.x == 1 || p.y == 1;
            };
            if (!closed) RC_ASSERT((at_border(line.front()) && at_border(line.back())));
            for (std::size_t i = 0; i < line.size(); ++i) {
                const double x = line[i].x * cells, y = line[i].y * cells;
                // On an edge of the grid, at the height in proportion.
                const double column = std::round(x), row = std::round(y);
                const bool upright = std::abs(x - column) < 1e-9;
                RC_ASSERT((upright || std::abs(y - row) < 1e-9));
                const auto c = static_cast<std::size_t>(upright ? column : std::floor(x));
                const auto r =
                    static_cast<std::size_t>(upright ? std::min(std::floor(y), cells - 1) : row);
                const double share =
                    upright ? y - static_cast<double>(r) : x - static_cast<double>(c);
                if (share < 0 || share > 1) continue;  // at a corner, rounded
                const double from = field.at(c, r);
                const double to =
                    upright ? field.at(c, r + 1) : field.at(std::min(c + 1, field.side - 1), r);
                RC_ASSERT(std::abs(from + share * (to - from) - height) < 1e-6);
            }
            points += line.size() - (closed ? 1 : 0);
        }
        // As many points as edges whose ends are on different sides.
        std::size_t crossed = 0;
        for (std::size_t row = 0; row < field.side; ++row)
            for (std::size_t column = 0; column < field.side; ++column) {
                const bool high = field.at(column, row) >= height;
                if (column + 1 < field.side)
                    crossed += high != (field.at(column + 1, row) >= height);
                if (row + 1 < field.side) crossed += high != (field.at(column, row + 1) >= height);
            }
        RC_ASSERT(points == crossed);
    }));
    // The area to the left of the lines around a hill is the hill's.
    const HeightField hill{3, {0, 0, 0, 0, 1, 0, 0, 0, 0}};
    const auto lines = contour_lines(hill, 0.5, {});
    REQUIRE(lines.size() == 1);
    double area = 0;
    for (std::size_t i = 1; i < lines[0].size(); ++i)
        area += (lines[0][i - 1].x * lines[0][i].y - lines[0][i].x * lines[0][i - 1].y) / 2;
    CHECK(area == doctest::Approx(0.125));
    // At a saddle, the mean says which corners belong together.
    CHECK(contour_lines({2, {1, 0, 0, 1.5}}, 0.5, {})[0].front() == Point{0.5, 0});
    CHECK(contour_lines({2, {1, 0, 0, 1.5}}, 0.5, {})[0].back().x == 1);
    CHECK(contour_lines({2, {0.9, 0, 0, 1}}, 0.5, {})[0].back().x == 0);
    CHECK(contour_lines({2, {0, 0.9, 1, 0}}, 0.5, {})[0].size() == 2);
}
