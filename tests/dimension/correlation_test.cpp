#include "dimension/detail/measures.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
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

TEST_CASE("the correlation sum refuses single points") {
    CHECK_THROWS_WITH_AS(correlation(PointSet{2, {{1, 1, 0}}}, {}, Budget()),
                         "expected at least 2 points to take the distance of, found 1", Error);
    CHECK_THROWS_WITH_AS(correlation(PointSet{2, {{1, 1, 0}, {1, 1, 0}}}, {}, Budget()),
                         "all points are the same: expected something to measure", Error);
    CHECK_THROWS_AS(correlation(*drawn("axiom f; f -> ff", 3), {}, Budget()), Error);
    CHECK(!correlation(random_cube(2, 30), {}, Budget()).estimate);
}
