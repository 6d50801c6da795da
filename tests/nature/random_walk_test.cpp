#include "nature/detail/random.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "exact/exact.hpp"

using namespace algae;

TEST_CASE("the mean square of the end of a walk grows as steps times dimensions") {
    for (const int dimensions : {1, 2, 3})
        for (const std::uint64_t steps : {1u, 100u}) {
            double sum = 0;
            const int walks = 4000;
            for (int seed = 0; seed < walks; ++seed) {
                const auto places =
                    random_walk({dimensions, steps, 2, static_cast<std::uint64_t>(seed)}, Budget());
                sum += dot(places.back(), places.back());
            }
            // A sum of `dimensions` squares has the standard deviation sqrt(2 / dimensions) of its mean.
            const double expected = 4.0 * static_cast<double>(steps) * dimensions;
            CAPTURE(dimensions);
            CAPTURE(steps);
            CHECK(std::abs(sum / walks / expected - 1) < 5 * std::sqrt(2.0 / dimensions / walks));
        }
}

TEST_CASE("a shorter walk is the beginning of a longer one") {
    CHECK(rc::check([](std::uint64_t seed) {
        const int dimensions = *rc::gen::inRange(1, 4);
        const std::uint64_t steps = *rc::gen::inRange(0u, 200u);
        const auto all = random_walk({dimensions, 200, 1, seed}, Budget());
        const auto part = random_walk({dimensions, steps, 1, seed}, Budget());
        RC_ASSERT(part.size() == steps + 1);
        for (std::size_t i = 0; i < part.size(); ++i) {
            RC_ASSERT(part[i] == all[i]);
            if (dimensions < 2) RC_ASSERT(part[i].y == 0);
            if (dimensions < 3) RC_ASSERT(part[i].z == 0);
        }
    }));
}

TEST_CASE("walks out of range are refused") {
    CHECK_THROWS_WITH_AS(random_walk({4, 10, 1, 1}, Budget()),
                         "dimensions: expected 1, 2 or 3, found 4", Error);
    CHECK_THROWS_WITH_AS(random_walk({2, 10, 0, 1}, Budget()),
                         "deviation: expected a number above 0, found 0.000000", Error);
    Budget small;
    small.memory = 1000;
    CHECK_THROWS_WITH_AS(random_walk({2, 1000, 1, 1}, small),
                         "a walk of 1000 steps takes more memory than the 1000 bytes allowed; use "
                         "fewer steps",
                         BoundReached);
}
