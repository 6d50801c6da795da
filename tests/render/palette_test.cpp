#include "render/detail/palette.hpp"

#include <doctest/doctest.h>

#include "exact/exact.hpp"

using namespace algae;

TEST_CASE("a palette comes round again and runs along") {
    const Palette black({}, 360);
    CHECK(black.colour(black.shade(7, 0.5)) == colour_named("black"));
    CHECK_FALSE(black.runs_along());

    const Palette two({"red", "along"}, 360);
    CHECK(two.runs_along());
    CHECK(two.colour(two.shade(2, 0.9)) == colour_named("red"));
    CHECK(two.colour(two.shade(1, 0)) == hue(0));
    CHECK(two.colour(two.shade(3, 0.5)) == hue(180));
    CHECK(two.colour(two.shade(1, 1)) == hue(359));
    CHECK_THROWS_AS(Palette({"red", "alnog"}, 360), Error);
}
