#include "dimension/detail/measures.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "dimension/known_curves.hpp"
#include "dimension/measured.hpp"
#include "exact/exact.hpp"

using namespace algae;

namespace {

PointSet square(int side) {
    PointSet points;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k)
            points.points.push_back({static_cast<double>(i), static_cast<double>(k), 0});
    return points;
}

}  // namespace

TEST_CASE("the length within a disc is that of many small pieces of the segment") {
    CHECK(length_within({-2, 0}, {2, 0}, {0, 0}, 1) == 2);
    CHECK(length_within({0, 0}, {0.5, 0}, {0, 0}, 1) == 0.5);
    CHECK(length_within({-2, 1}, {2, 1}, {0, 0}, 1) == 0);
    CHECK(length_within({1, 1}, {1, 1}, {1, 1}, 1) == 0);
    CHECK(rc::check("length", [] {
        const auto any = rc::gen::map(rc::gen::inRange(-300, 300), [](int k) { return k / 100.0; });
        const Point from{*any, *any}, to{*any, *any}, centre{*any, *any};
        const double radius = *rc::gen::inRange(1, 300) / 100.0;
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        int within = 0;
        for (int k = 0; k < 4000; ++k) {
            const double share = (k + 0.5) / 4000;
            within += std::hypot(from.x + share * (to.x - from.x) - centre.x,
                                 from.y + share * (to.y - from.y) - centre.y) < radius;
        }
        RC_ASSERT(std::abs(length_within(from, to, centre, radius) - within * length / 4000) <=
                  length / 1000 + 1e-9);
    }));
}

TEST_CASE("how many halved radii hold a distance is what comparing says") {
    CHECK(rc::check("radii", [] {
        const double greatest = *rc::gen::inRange(1, 1000) / 64.0,
                     away = *rc::gen::inRange(0, 1000) / 64.0;
        std::size_t count = 0;
        double radius = greatest;
        for (int i = 0; i < 8; ++i, radius /= 2) count += away <= radius;
        RC_ASSERT(halved_radii(greatest, away, 8) == count);
    }));
}

TEST_CASE("masses of a figure are sums over all centres and segments, one radius at a time") {
    CHECK(rc::check("masses", [] {
        const auto figure =
            drawn(*rc::gen::elementOf(std::vector{"axiom F; F -> F+F--F+F; angle 60",
                                                  "axiom F; F -> F[+F]F[-F]F; angle 25.7"}),
                  3);
        const Sandboxes sandboxes{*rc::gen::inRange<std::size_t>(1, 9),
                                  *rc::gen::arbitrary<std::uint64_t>()};
        const Scaling found = mass(*figure, sandboxes, Budget());
        const PointSet centres =
            even_sample(*figure, sandboxes.centres, Spread::stretches, sandboxes.seed, Budget());
        struct List : Canvas {
            std::vector<std::pair<Point, Point>> segments;
            Point here;
            void move_to(Point point) override { here = point; }
            void line_to(Point point) override {
                segments.emplace_back(here, point);
                here = point;
            }
            void polygon(std::span<const Point>) override {}
            void width(double) override {}
            void width_as_length(double) override {}
            void colour(std::uint32_t) override {}
            void position(double) override {}
        } list;
        figure->draw(list, 0, Budget());
        for (std::size_t i = 0; i < found.sizes.size(); ++i) {
            double sum = 0;
            for (const auto& centre : centres.points)
                for (const auto& [from, to] : list.segments)
                    sum += length_within(from, to, {centre[0], centre[1]}, found.sizes[i]);
            RC_ASSERT(std::abs(found.values[i] - sum / static_cast<double>(sandboxes.centres)) <
                      1e-9);
        }
    }));
}

TEST_CASE("sandboxes find the dimension of lines, curves and squares") {
    check_holds(mass(*drawn("axiom F; F -> FF; angle 60", 13), {}, Budget()), 1, 0.02);
    check_holds(mass(*drawn("axiom F; F -> F+F--F+F; angle 60", 8), {}, Budget()),
                std::log(4) / std::log(3), 0.05);
    check_holds(mass(*drawn("axiom F; F -> FfF; f -> fff; angle 90", 11), {}, Budget()),
                std::log(2) / std::log(3), 0.07);
    check_holds(mass(square(200), {}, Budget()), 2, 0.12);
}

TEST_CASE("sandboxes refuse what has no length") {
    CHECK_THROWS_WITH_AS(mass(*drawn("axiom f; f -> ff", 3), {}, Budget()),
                         "nothing is drawn: expected something to measure", Error);
    CHECK_THROWS_WITH_AS(mass(square(9), {0, 1}, Budget()), "expected at least one centre, found 0",
                         Error);
    CHECK_THROWS_WITH_AS(mass(PointSet{2, {{1, 1, 0}, {1, 1, 0}}}, {}, Budget()),
                         "all points are the same: expected something to measure", Error);
    CHECK(!mass(*drawn("axiom F; F -> F+F--F+F; angle 60", 2), {}, Budget()).estimate);
}

TEST_CASE("an even sample has a point in each stretch of the length") {
    const auto figure = drawn("axiom F; F -> FF; angle 60", 5);
    const PointSet sample = even_sample(*figure, 64, Spread::stretches, 7, Budget());
    REQUIRE(sample.points.size() == 64);
    for (std::size_t i = 0; i < 64; ++i)
        CHECK(std::floor(sample.points[i][0] * 2) == static_cast<double>(i));
    CHECK(even_sample(*figure, 64, Spread::stretches, 7, Budget()).points == sample.points);
    CHECK(even_sample(*figure, 64, Spread::stretches, 8, Budget()).points != sample.points);
    CHECK(even_sample(*figure, 99, Spread::independent, 8, Budget()).points.size() == 99);
    CHECK(even_sample(square(10), 7, 1).points.size() == 7);
    CHECK(even_sample(square(10), 100, 1).points == square(10).points);
}
