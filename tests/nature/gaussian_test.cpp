#include "nature/detail/random.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdint>
#include <vector>

using namespace algae;

TEST_CASE("Gaussian numbers have the moments of the normal distribution") {
    const Gaussians numbers(7, 3);
    const std::uint32_t count = 400'000;
    double sum = 0, squares = 0, fourths = 0, products = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double x = numbers.at(i);
        sum += x;
        squares += x * x;
        fourths += x * x * x * x;
        products += x * numbers.at(i + 1);
    }
    // Five standard errors: 1, sqrt 2, sqrt 96 and 1, over the root of the count.
    const double error = 5 / std::sqrt(count);
    CHECK(std::abs(sum / count) < error);
    CHECK(std::abs(squares / count - 1) < error * std::sqrt(2));
    CHECK(std::abs(fourths / count - 3) < error * std::sqrt(96));
    CHECK(std::abs(products / count) < error);
}

TEST_CASE("shares of Gaussian numbers below a bound are those of the error function") {
    const Gaussians numbers(1, 0);
    const std::uint32_t count = 200'000;
    for (const double bound : {-2.5, -1.0, -0.3, 0.0, 0.5, 1.5, 3.0}) {
        int below = 0;
        for (std::uint32_t i = 0; i < count; ++i) below += numbers.at(i) < bound;
        const double share = std::erfc(-bound / std::sqrt(2)) / 2;
        CAPTURE(bound);
        CHECK(std::abs(static_cast<double>(below) / count - share) <
              5 * std::sqrt(share * (1 - share) / count));
    }
}

TEST_CASE("a Gaussian number depends on seed, stream and position alone") {
    CHECK(rc::check([](std::uint64_t seed, std::uint64_t stream, std::uint32_t position) {
        const Gaussians numbers(seed, stream);
        const double first = numbers.at(position);
        numbers.at(position + 1);
        RC_ASSERT(numbers.at(position) == first);
        RC_ASSERT(std::isfinite(first));
        RC_ASSERT(Gaussians(seed, stream + 1).at(position) != first);
    }));
}

TEST_CASE("numbers of the unit interval are never 0 or 1") {
    CHECK(unit_interval(0) > 0);
    CHECK(unit_interval(~std::uint64_t{0}) < 1);
}
