#include "dimension/detail/measures.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "dimension/measured.hpp"
#include "exact/exact.hpp"

using namespace algae;

namespace {

PointSet random_cube(int columns, std::size_t count) {
    std::mt19937_64 random(11);
    PointSet points{columns, {}};
    for (std::size_t i = 0; i < count; ++i) {
        std::array<double, 3> point{};
        for (int k = 0; k < columns; ++k)
            point[static_cast<std::size_t>(k)] =
                static_cast<double>(random() % 1'000'003) / 1'000'003;
        points.points.push_back(point);
    }
    return points;
}

}  // namespace

TEST_CASE("pairs by cells are the pairs of a double loop") {
    CHECK(rc::check("pairs", [] {
        const auto coordinate =
            rc::gen::map(rc::gen::inRange(-40, 40), [](int k) { return k / 8.0; });
        const int columns = *rc::gen::inRange(1, 4);
        PointSet set{columns, {}};
        for (int i = *rc::gen::inRange(2, 40); i > 0; --i) {
            std::array<double, 3> point{};
            for (int k = 0; k < columns; ++k) point[static_cast<std::size_t>(k)] = *coordinate;
            set.points.push_back(point);
        }
        const double greatest = *rc::gen::inRange(1, 40) / 8.0;
        const auto pairs = near_pairs(set, greatest, 5, Budget());
        double radius = greatest;
        for (std::size_t r = 0; r < 5; ++r, radius /= 2) {
            std::uint64_t count = 0;
            for (std::size_t i = 0; i < set.points.size(); ++i)
                for (std::size_t k = 0; k < i; ++k)
                    count += distance(set.points[i], set.points[k]) <= radius;
            RC_ASSERT(pairs[r] == count);
        }
    }));
}

TEST_CASE("the correlation sum finds the dimension of lines, curves and squares") {
    const CorrelationSample sample{8'000, 1};
    check_holds(correlation(*drawn("axiom F; F -> FF; angle 60", 14), sample, Budget()), 1, 0.02);
    check_holds(correlation(*drawn("axiom F; F -> F+F--F+F; angle 60", 9), sample, Budget()),
                std::log(4) / std::log(3), 0.04);
    check_holds(correlation(*drawn("axiom F; F -> FfF; f -> fff; angle 90", 12), sample, Budget()),
                std::log(2) / std::log(3), 0.06);
    check_holds(correlation(random_cube(1, 8'000), sample, Budget()), 1, 0.03);
    check_holds(correlation(random_cube(2, 8'000), sample, Budget()), 2, 0.1);
}

namespace {

/// So many points of the chaos game of maps z -> factor z + shift, each then moved by normal noise.
struct Maps {
    std::vector<std::pair<std::complex<double>, std::complex<double>>> all;
    PointSet points(std::size_t count, double noise, unsigned seed) const {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> move(0, noise);
        std::complex<double> z;
        PointSet found{2, {}};
        for (std::size_t k = 0; k < count + 50; ++k) {
            const auto& [factor, shift] = all[random() % all.size()];
            z = factor * z + shift;
            if (k >= 50)
                found.points.push_back({z.real() + (noise > 0 ? move(random) : 0),
                                        z.imag() + (noise > 0 ? move(random) : 0), 0});
        }
        return found;
    }
};

std::complex<double> turned(double size, double degrees) {
    return std::polar(size, degrees * std::numbers::pi / 180);
}

const Maps gasket{{{0.5, 0}, {0.5, 0.5}, {0.5, {0.25, 0.433}}}};
const Maps koch{{{1 / 3.0, 0},
                 {turned(1 / 3.0, 60), 1 / 3.0},
                 {turned(1 / 3.0, -60), {0.5, 0.2886751}},
                 {1 / 3.0, 2 / 3.0}}};
const Maps dust{{{0.45, 0}, {0.45, 0.55}, {0.45, {0, 0.55}}, {0.45, {0.55, 0.55}}}};

}  // namespace

TEST_CASE("noisy points: the closed form of the correlation sum is the sum") {
    // Pairs at the distance x with density x^(D-1), one of them moved by sqrt 2 times the noise in each coordinate.
    std::size_t compared = 0;
    for (const int space : {2, 3})
        for (const double dimension : {0.7, 1.3, 1.9}) {
            std::mt19937_64 random(5);
            std::normal_distribution<double> move(0, std::numbers::sqrt2);
            const std::vector<double> radii{0.5, 1, 2, 4, 8};
            std::vector<double> within(radii.size());
            const double widest = 20;  // moves from farther away hardly reach the greatest radius
            for (int k = 0; k < 400'000; ++k) {
                const double share = std::ldexp(static_cast<double>(random() >> 11), -53);
                double square = 0;
                for (int i = 0; i < space; ++i) {
                    const double at =
                        (i == 0 ? widest * std::pow(share, 1 / dimension) : 0) + move(random);
                    square += at * at;
                }
                for (std::size_t r = 0; r < radii.size(); ++r)
                    within[r] += square <= radii[r] * radii[r];
            }
            for (std::size_t r = 0; r + 1 < radii.size(); ++r) {
                if (within[r] < 2000) continue;
                const double expected = noisy_correlation(dimension, space, 1, radii[r + 1]) -
                                        noisy_correlation(dimension, space, 1, radii[r]);
                CAPTURE(space);
                CAPTURE(dimension);
                CAPTURE(radii[r]);
                CHECK(std::log(within[r + 1] / within[r]) ==
                      doctest::Approx(expected).epsilon(0.05));
                ++compared;
            }
        }
    CHECK(compared >= 12);
    // The series and its continuation for large arguments meet.
    for (const double radius : {15.4, 15.5})
        CHECK(noisy_correlation(1.3, 2, 1, radius) - noisy_correlation(1.3, 2, 1, radius - 0.1) ==
              doctest::Approx(1.3 * std::log(radius / (radius - 0.1))).epsilon(0.02));
}

TEST_CASE("a gasket with noise of 0.005 is not the plane: its dimension and the noise are found") {
    std::size_t found = 0;
    for (const auto& [maps, dimension] : {std::pair(gasket, std::log(3) / std::log(2)),
                                          {koch, std::log(4) / std::log(3)},
                                          {dust, std::log(4) / -std::log(0.45)}})
        for (const double noise : {0.005, 0.01}) {
            const PointSet points = maps.points(60'000, noise, 3);
            const Scaling scaling = correlation(points, {}, Budget());
            CAPTURE(dimension);
            CAPTURE(noise);
            CAPTURE(scaling.because);
            REQUIRE(scaling.estimate);
            CHECK(scaling.noise == doctest::Approx(noise).epsilon(0.12));
            CHECK(std::abs(scaling.estimate->value - dimension) < 0.05);
            CHECK(scaling.estimate->low <= dimension);
            CHECK(dimension <= scaling.estimate->high);
            const Scaling by_mass = mass(points, {500, 1}, Budget());
            CHECK(by_mass.noise == scaling.noise);
            CHECK(by_mass.estimate->value == scaling.estimate->value);
            ++found;
        }
    CHECK(found == 6);
}

TEST_CASE("no noise is seen in points of curves, of dusts, and of what fills an area") {
    const Maps dragon{{{turned(std::sqrt(0.5), 45), 0}, {turned(std::sqrt(0.5), 135), 1}}};
    const Maps levy{{{turned(std::sqrt(0.5), 45), 0}, {turned(std::sqrt(0.5), -45), {0.5, 0.5}}}};
    const Maps square{{{0.5, 0}, {0.5, 0.5}, {0.5, {0, 0.5}}, {0.5, {0.5, 0.5}}}};
    const Maps carpet{{{1 / 3.0, 0},
                       {1 / 3.0, 1 / 3.0},
                       {1 / 3.0, 2 / 3.0},
                       {1 / 3.0, {0, 1 / 3.0}},
                       {1 / 3.0, {2 / 3.0, 1 / 3.0}},
                       {1 / 3.0, {0, 2 / 3.0}},
                       {1 / 3.0, {1 / 3.0, 2 / 3.0}},
                       {1 / 3.0, {2 / 3.0, 2 / 3.0}}}};
    std::size_t looked_at = 0;
    for (const Maps& maps : {gasket, koch, dust, dragon, levy, square, carpet})
        for (const std::size_t count : {3'000u, 6'000u, 60'000u}) {
            CAPTURE(looked_at);
            CHECK(correlation(maps.points(count, 0, 4), {}, Budget()).noise == 0);
            CHECK(mass(maps.points(count, 0, 4), {500, 1}, Budget()).noise == 0);
            ++looked_at;
        }
    CHECK(looked_at == 21);
}

TEST_CASE("the correlation sum refuses single points") {
    CHECK_THROWS_WITH_AS(correlation(PointSet{2, {{1, 1, 0}}}, {}, Budget()),
                         "expected at least 2 points to take the distance of, found 1", Error);
    CHECK_THROWS_WITH_AS(correlation(PointSet{2, {{1, 1, 0}, {1, 1, 0}}}, {}, Budget()),
                         "all points are the same: expected something to measure", Error);
    CHECK_THROWS_AS(correlation(*drawn("axiom f; f -> ff", 3), {}, Budget()), Error);
    CHECK(!correlation(random_cube(2, 30), {}, Budget()).estimate);
}
