#include "render/detail/palette.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "exact/exact.hpp"

using namespace algae;

namespace {

/// The luminance of WCAG 2, written down once more.
double light(const Colour& colour) {
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) +
           0.0722 * linear(colour.blue);
}

double contrast(const Colour& one, const Colour& other) {
    const double a = light(one) + 0.05, b = light(other) + 0.05;
    return a > b ? a / b : b / a;
}

}  // namespace

TEST_CASE("a palette comes round again and runs along") {
    const Palette black({}, 360);
    CHECK(black.colour(black.shade(7, 0.5)) == colour_named("black"));
    CHECK_FALSE(black.runs_along());

    const Palette two({"red", "along"}, 360);
    CHECK(two.runs_along());
    CHECK(two.colour(two.shade(2, 0.9)) == colour_named("red"));
    CHECK(two.colour(two.shade(1, 0)) == scheme_colour("along", 0));
    CHECK(two.colour(two.shade(3, 0.5)) == scheme_colour("along", 0.5));
    CHECK(two.colour(two.shade(1, 1)) == scheme_colour("along", 359.0 / 360));
    CHECK_THROWS_AS(Palette({"red", "alnog"}, 360), Error);

    const Palette three({"viridis", "along", "cividis"}, 10);
    CHECK(three.colour(three.shade(0, 1)) == colour_named("#fde725"));
    CHECK(three.colour(three.shade(2, 0)) == colour_named("#00204d"));
    CHECK(three.colour(three.shade(1, 0.35)) == scheme_colour("along", 0.3));
}

TEST_CASE("the hues of along can be read on white and on black, and are equally light") {
    double least = 1, most = 0;
    for (int i = 0; i < 360; ++i) {
        const Colour colour = scheme_colour("along", i / 360.0);
        CHECK(contrast(colour, {1, 1, 1}) >= 2.7);
        CHECK(contrast(colour, {0, 0, 0}) >= 5);
        least = std::min(least, light(colour));
        most = std::max(most, light(colour));
    }
    CHECK(most - least < 0.12);  // the pure hues of before: 0.86
}

TEST_CASE("viridis and cividis become lighter from end to end") {
    for (const char* scheme : {"viridis", "cividis"})
        for (int i = 0; i < 100; ++i)
            CHECK(light(scheme_colour(scheme, i / 100.0)) <
                  light(scheme_colour(scheme, (i + 1) / 100.0)));
}

TEST_CASE("a colour that cannot be read becomes readable and keeps what it can") {
    int changed = 0;
    for (const char* page : {"#15171a", "white", "#808080"})
        for (const std::string_view name : colour_names()) {
            const Colour colour = colour_named(name), background = colour_named(page);
            const Colour found = readable_on(colour, background);
            CHECK(contrast(found, background) >= 2.99);
            if (contrast(colour, background) >= 3)
                CHECK(found == colour);
            else
                ++changed;
        }
    CHECK(changed > 20);
}
