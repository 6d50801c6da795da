#include "turtle/turtle.hpp"

#include <doctest/doctest.h>

#include "exact/exact.hpp"

using namespace algae;

TEST_CASE("colours by name and by code") {
    CHECK(colour_named("black") == Colour{0, 0, 0});
    CHECK(colour_named("White") == Colour{1, 1, 1});
    CHECK(colour_named("#ff0000") == colour_named("red"));
    CHECK(colour_named("#0F0") == colour_named("lime"));
    CHECK(colour_named("#336699") == colour_named("#369"));
    CHECK(colour_named("darkgreen").green == doctest::Approx(100 / 255.0));
}

TEST_CASE("an unknown colour is an error that helps") {
    CHECK_THROWS_WITH_AS(colour_named("darkgren"),
                         "there is no colour \"darkgren\"; did you mean \"darkgreen\"?", Error);
    CHECK_THROWS_WITH_AS(colour_named("qqqqqqqq"),
                         "there is no colour \"qqqqqqqq\"; expected a name such as \"red\" or "
                         "\"darkgreen\", or a code such as #008000",
                         Error);
    CHECK_THROWS_WITH_AS(colour_named(""),
                         "there is no colour \"\"; expected a name such as \"red\" or "
                         "\"darkgreen\", or a code such as #008000",
                         Error);
    CHECK_THROWS_WITH_AS(colour_named("#12345"),
                         "expected a colour like #080 or #008000, found \"#12345\"", Error);
    CHECK_THROWS_AS(colour_named("#ggg"), Error);
}

TEST_CASE("hues are pure colours") {
    CHECK(hue(0) == colour_named("red"));
    CHECK(hue(60) == colour_named("yellow"));
    CHECK(hue(120) == colour_named("lime"));
    CHECK(hue(180) == colour_named("cyan"));
    CHECK(hue(240) == colour_named("blue"));
    CHECK(hue(300) == colour_named("magenta"));
    CHECK(hue(360) == hue(0));
    CHECK(hue(30).green == doctest::Approx(0.5));
}
