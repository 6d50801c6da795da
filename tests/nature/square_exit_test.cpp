#include "nature/detail/aggregates.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <vector>

#include "exact/exact.hpp"
#include "rewrite/rewrite.hpp"

using namespace algae;

namespace {

/// The chances of leaving the square at (r, y), by spreading one walker over the cells step by step
/// until nothing worth counting is left inside.
std::vector<double> by_spreading(int r) {
    const int side = 2 * r + 1;
    std::vector<double> now(static_cast<std::size_t>(side * side)), out(now.size());
    const auto at = [&](int x, int y) { return static_cast<std::size_t>((y + r) * side + x + r); };
    now[at(0, 0)] = 1;
    for (int step = 0; step < 60 * r * r; ++step) {
        std::vector<double> later(now.size());
        for (int y = -r + 1; y < r; ++y)
            for (int x = -r + 1; x < r; ++x)
                for (const auto& [across, along] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
                    const std::size_t to = at(x + across, y + along);
                    const bool border = std::abs(x + across) == r || std::abs(y + along) == r;
                    (border ? out : later)[to] += now[at(x, y)] / 4;
                }
        now = std::move(later);
    }
    std::vector<double> side_shares;
    for (int y = -r + 1; y < r; ++y) side_shares.push_back(out[at(r, y)]);
    return side_shares;
}

}  // namespace

TEST_CASE("the chances of leaving a square are those of walking step by step") {
    for (const int r : {1, 2, 3, 4, 5, 8, 13}) {
        const auto shares = by_spreading(r);
        for (int y = -r + 1; y < r; ++y) {
            CAPTURE(r);
            CAPTURE(y);
            CHECK(std::abs(square_exit_chance(r, y) - shares[static_cast<std::size_t>(y + r - 1)]) <
                  1e-12);
        }
    }
}

TEST_CASE("the chances of all cells of a side are a quarter together") {
    for (std::int64_t r = 1; r <= 2048; r *= 2) {
        double sum = 0;
        for (std::int64_t y = -r + 1; y < r; ++y) sum += square_exit_chance(r, y);
        CHECK(std::abs(sum - 0.25) < 1e-12);
    }
    CHECK_THROWS_WITH_AS(square_exit_chance(3, 3),
                         "a side of a square: expected |y| < r, found r = 3 and y = 3", Error);
}

TEST_CASE("draws from the tables have these chances") {
    const Draws draws(11, 0);
    std::uint64_t number = 0;
    for (const int exponent : {0, 1, 2, 4}) {
        const std::int64_t r = std::int64_t{1} << exponent;
        std::map<std::pair<std::int64_t, std::int64_t>, int> counts;
        const int count = 200'000;
        for (int i = 0; i < count; ++i) {
            const auto first = draws.at(number++), second = draws.at(number++);
            const auto step = SquareExits::tables().at(exponent, first, second);
            ++counts[{step.x, step.y}];
        }
        CHECK(counts.size() == static_cast<std::size_t>(4 * (2 * r - 1)));
        double chi = 0;
        for (const auto& [step, found] : counts) {
            const bool across = std::abs(step.first) == r;
            CHECK((across || std::abs(step.second) == r));
            const double expected =
                count * square_exit_chance(r, across ? step.second : step.first);
            chi += (found - expected) * (found - expected) / expected;
        }
        // A chi-square with k degrees of freedom has mean k and variance 2k.
        const double freedom = static_cast<double>(counts.size()) - 1;
        CAPTURE(exponent);
        CHECK(chi < freedom + 5 * std::sqrt(2 * freedom) + 10);
    }
}
