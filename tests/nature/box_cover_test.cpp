#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/exact.hpp"
#include "nature/nature.hpp"

using namespace algae;

TEST_CASE("a coast that boxes cover is closed, and rougher than a smooth line") {
    BoxCover cover;
    cover.shape = BoxCover::Shape::coast;
    double slopes = 0;
    int coasts = 0;
    for (const std::uint64_t seed : {2U, 3U, 4U, 6U, 7U}) {
        cover.seed = seed;
        const std::vector<Stroke> lines = cover.strokes({});
        REQUIRE(lines.size() == 1);
        CHECK(lines[0].front() == lines[0].back());
        CHECK(lines[0].size() > 500);
        Box box;
        for (const Point& point : lines[0]) box.add(point);
        CHECK(std::max(box.breadth(), box.height()) == doctest::Approx(1));
        const auto count = [&](double side) {
            return static_cast<double>(cover.covering(side, {}).size());
        };
        slopes += std::log2(count(1.0 / 128) / count(1.0 / 16)) / 3;
        ++coasts;
    }
    CHECK(coasts == 5);
    CHECK(slopes / coasts > 1.1);
    CHECK(slopes / coasts < 1.35);
}
