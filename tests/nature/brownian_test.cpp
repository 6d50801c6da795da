#include "nature/detail/random.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <vector>

#include "exact/exact.hpp"

using namespace algae;

namespace {

/// The variance that fractional Brownian motion has between two times.
double required(const BrownianMotion& motion, double from, double to) {
    return motion.sigma * motion.sigma * std::pow(std::abs(to - from), 2 * motion.hurst);
}

/// What each value of a path by midpoint displacement is made of: a row of factors of the
/// displacements, each with its variance. Built from the top, value by value.
struct Parts {
    std::vector<std::vector<double>> rows;
    std::vector<double> variances;

    explicit Parts(const BrownianMotion& motion) {
        const std::size_t pieces = std::size_t{1} << motion.levels;
        rows.assign(pieces + 1, std::vector<double>(pieces));
        variances.push_back(motion.sigma * motion.sigma);
        rows[pieces][0] = 1;
        for (int level = 1; level <= motion.levels; ++level) {
            const std::size_t half = pieces >> level;
            for (std::size_t i = half; i < pieces; i += 2 * half) {
                for (std::size_t k = 0; k < variances.size(); ++k)
                    rows[i][k] = 0.5 * rows[i - half][k] + 0.5 * rows[i + half][k];
                rows[i][variances.size()] = 1;
                variances.push_back(motion.sigma * motion.sigma *
                                    (1 - std::pow(2, 2 * motion.hurst - 2)) /
                                    std::pow(std::pow(2, level), 2 * motion.hurst));
            }
        }
    }
    double variance(std::size_t from, std::size_t to) const {
        double sum = 0;
        for (std::size_t k = 0; k < variances.size(); ++k)
            sum += variances[k] * (rows[to][k] - rows[from][k]) * (rows[to][k] - rows[from][k]);
        return sum;
    }
};

}  // namespace

TEST_CASE("the variances of displacements are those printed for H = 1/2 and for H = 0.7") {
    const double half[] = {0.25, 0.125, 0.0625, 0.03125};
    const double rough[] = {0.128929, 0.048855, 0.018513, 0.007015};
    for (int n = 1; n <= 4; ++n) {
        CHECK(displacement_variance({0.5, 1, 0}, n) == half[n - 1]);
        CHECK(displacement_variance({0.5, 3, 0}, n) == doctest::Approx(9 * half[n - 1]));
        CHECK(std::abs(displacement_variance({0.7, 1, 0}, n) - rough[n - 1]) < 5e-7);
    }
}

TEST_CASE("paths by midpoint displacement are displaced by what the formula says") {
    const BrownianMotion motion{0.7, 2, 5};
    const int paths = 4000;
    std::vector<double> squares(6), counts(6);
    for (int seed = 0; seed < paths; ++seed) {
        const auto path = midpoint_path(motion, Gaussians(static_cast<std::uint64_t>(seed), 0), {});
        REQUIRE(path.size() == 33);
        CHECK(path[0] == 0);
        squares[0] += path[32] * path[32];
        ++counts[0];
        for (int level = 1; level <= 5; ++level)
            for (std::size_t half = 32u >> level, i = half; i < 32; i += 2 * half) {
                const double displaced = path[i] - (path[i - half] + path[i + half]) / 2;
                squares[static_cast<std::size_t>(level)] += displaced * displaced;
                ++counts[static_cast<std::size_t>(level)];
            }
    }
    for (int level = 0; level <= 5; ++level) {
        const double count = counts[static_cast<std::size_t>(level)];
        const double expected = level == 0 ? 4 : displacement_variance(motion, level);
        CAPTURE(level);
        CHECK(std::abs(squares[static_cast<std::size_t>(level)] / count / expected - 1) <
              5 * std::sqrt(2 / count));
    }
}

TEST_CASE("a path with fewer levels is the coarser version of the same path") {
    const auto fine = midpoint_path({0.3, 1, 8}, Gaussians(5, 0), {});
    const auto coarse = midpoint_path({0.3, 1, 5}, Gaussians(5, 0), {});
    for (std::size_t i = 0; i < coarse.size(); ++i) CHECK(fine[8 * i] == coarse[i]);
}

TEST_CASE("the variance of increments by midpoint displacement, against a second route") {
    CHECK(rc::check([] {
        const BrownianMotion motion{*rc::gen::inRange(1, 100) / 100.0,
                                    *rc::gen::inRange(1, 9) / 4.0, *rc::gen::inRange(0, 7)};
        const std::size_t pieces = std::size_t{1} << motion.levels;
        const auto from = *rc::gen::inRange<std::size_t>(0, pieces + 1);
        const auto to = *rc::gen::inRange<std::size_t>(0, pieces + 1);
        const double found = midpoint_increment_variance(motion, from, to);
        RC_ASSERT(std::abs(found - Parts(motion).variance(from, to)) < 1e-12 * (1 + found));
    }));
}

TEST_CASE("midpoint displacement is Brownian motion for H = 1/2, and for no other H") {
    const int levels = 6;
    for (const double hurst : {0.2, 0.5, 0.8}) {
        const BrownianMotion motion{hurst, 1, levels};
        double least = 10, most = 0;
        for (std::uint64_t from = 0; from < 64; ++from)
            for (std::uint64_t to = from + 1; to <= 64; ++to) {
                const double share =
                    midpoint_increment_variance(motion, from, to) /
                    required(motion, static_cast<double>(from) / 64, static_cast<double>(to) / 64);
                least = std::min(least, share);
                most = std::max(most, share);
            }
        CAPTURE(hurst);
        if (hurst == 0.5) {
            CHECK(least == doctest::Approx(1));
            CHECK(most == doctest::Approx(1));
        } else if (hurst > 0.5) {
            CHECK(least < 0.95);
        } else {
            CHECK(most > 1.05);
        }
    }
    // Increments over half the time, at the beginning and in the middle: they should be equal, and
    // are 1/4 + 2 D_2 there, where D_2 is the variance of the second displacement.
    const BrownianMotion smooth{0.8, 1, 2};
    CHECK(midpoint_increment_variance(smooth, 0, 2) == doctest::Approx(required(smooth, 0, 0.5)));
    CHECK(midpoint_increment_variance(smooth, 2, 4) == doctest::Approx(required(smooth, 0, 0.5)));
    CHECK(midpoint_increment_variance(smooth, 1, 3) ==
          doctest::Approx(0.25 + 2 * displacement_variance(smooth, 2)));
    CHECK(midpoint_increment_variance(smooth, 1, 3) < 0.92 * required(smooth, 0, 0.5));
    const BrownianMotion rough{0.2, 1, 2};
    CHECK(midpoint_increment_variance(rough, 1, 3) > 1.02 * required(rough, 0, 0.5));
}

TEST_CASE(
    "samples show the same: midpoint displacement depends on the place, the exact method not") {
    const BrownianMotion motion{0.8, 1, 4};
    const int paths = 20'000;
    double middle[2] = {}, first[2] = {};
    for (int seed = 0; seed < paths; ++seed) {
        const Gaussians numbers(static_cast<std::uint64_t>(seed), 9);
        const std::vector<double> both[2] = {midpoint_path(motion, numbers, {}),
                                             exact_path(motion, numbers, {})};
        for (int k = 0; k < 2; ++k) {
            first[k] += both[k][8] * both[k][8] / paths;
            const double across = both[k][12] - both[k][4];
            middle[k] += across * across / paths;
        }
    }
    const double error = 5 * std::sqrt(2.0 / paths), wanted = required(motion, 0, 0.5);
    CHECK(std::abs(first[0] / wanted - 1) < error);
    CHECK(std::abs(first[1] / wanted - 1) < error);
    CHECK(std::abs(middle[1] / wanted - 1) < error);
    CHECK(std::abs(middle[0] / midpoint_increment_variance(motion, 4, 12) - 1) < error);
    CHECK(middle[0] < 0.95 * wanted);
}

TEST_CASE("the covariance of increments, against its formula in more digits") {
    CHECK(rc::check([] {
        const double hurst = *rc::gen::inRange(1, 100) / 100.0;
        const auto lag = *rc::gen::inRange<std::uint64_t>(0, 3000);
        const long double e = 2 * static_cast<long double>(hurst), k = lag;
        const long double direct =
            (std::pow(k + 1, e) - 2 * std::pow(k, e) + std::pow(std::abs(k - 1), e)) / 2;
        RC_ASSERT(std::abs(increment_covariance(hurst, lag) - static_cast<double>(direct)) < 1e-11);
    }));
}

TEST_CASE("the covariance of exact paths is that of fractional Brownian motion") {
    for (const double hurst : {0.1, 0.5, 0.75, 0.95}) {
        const BrownianMotion motion{hurst, 1.5, 3};
        const int paths = 20'000;
        std::vector<std::vector<double>> sums(9, std::vector<double>(9));
        for (int seed = 0; seed < paths; ++seed) {
            const auto path =
                exact_path(motion, Gaussians(static_cast<std::uint64_t>(seed), 1), {});
            for (std::size_t i = 1; i < 9; ++i)
                for (std::size_t j = 1; j <= i; ++j) sums[i][j] += path[i] * path[j] / paths;
        }
        for (std::size_t i = 1; i < 9; ++i)
            for (std::size_t j = 1; j <= i; ++j) {
                const double s = static_cast<double>(i) / 8, t = static_cast<double>(j) / 8;
                const double vs = required(motion, 0, s), vt = required(motion, 0, t);
                const double covariance = (vs + vt - required(motion, s, t)) / 2;
                const double error = std::sqrt((vs * vt + covariance * covariance) / paths);
                CAPTURE(hurst);
                CAPTURE(i);
                CAPTURE(j);
                CHECK(std::abs(sums[i][j] - covariance) < 5 * error);
            }
    }
}

TEST_CASE("the estimated H of 200 exact paths is within 0.02 of the parameter, each of them") {
    for (const double hurst : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        double mean = 0, worst = 0;
        for (std::uint64_t seed = 0; seed < 40; ++seed) {  // 200 with all H
            const auto path = exact_path({hurst, 1, 15}, Gaussians(seed, 4), {});
            const double found = estimated_hurst(path);
            mean += found / 40;
            worst = std::max(worst, std::abs(found - hurst));
        }
        CAPTURE(hurst);
        CHECK(worst < 0.02);
        CHECK(std::abs(mean - hurst) < 0.004);
    }
}

TEST_CASE("parameters out of range are refused") {
    const Gaussians numbers(1, 0);
    CHECK_THROWS_WITH_AS(midpoint_path({1, 1, 3}, numbers, {}),
                         "hurst: expected a number between 0 and 1, found 1", Error);
    CHECK_THROWS_WITH_AS(exact_path({0, 1, 3}, numbers, {}),
                         "hurst: expected a number between 0 and 1, found 0", Error);
    CHECK_THROWS_WITH_AS(exact_path({0.5, -1, 3}, numbers, {}),
                         "sigma: expected a number above 0, found -1", Error);
    CHECK_THROWS_WITH_AS(exact_path({0.5, 1, 25}, numbers, {}),
                         "levels: expected 0 to 24, found 25", Error);
    CHECK_THROWS_WITH_AS(exact_path({0.5, 1, -1}, numbers, {}),
                         "levels: expected 0 to 24, found -1", Error);
    Budget small;
    small.memory = 100;
    CHECK_THROWS_AS(exact_path({0.5, 1, 10}, numbers, small), BoundReached);
    CHECK_THROWS_WITH_AS(estimated_hurst({0, 1, 2, 3, 4, 5, 6}),
                         "expected a rough path, found values on a line", Error);
}
