#include "turtle/turtle.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "model/model.hpp"

using namespace algae;

namespace {

Compass compass(const char* angle, const char* heading = "0", const char* spin = "0",
                std::uint64_t n = 0, bool clockwise = false) {
    Drawing settings;
    settings.angle = quantity(Rational(angle));
    settings.start =
        Drawing::Start{quantity(Rational(0)), quantity(Rational(0)), quantity(Rational(heading))};
    settings.spin = quantity(Rational(spin));
    settings.clockwise = clockwise;
    return Compass(settings, n);
}

Compass irrational(double angle) {
    Drawing settings;
    settings.angle = quantity(Rational(1));
    settings.angle->exact.reset();
    settings.angle->value = angle;
    return Compass(settings, 0);
}

/// Where + leads to from the start, in degrees.
double degrees(const Compass& compass, Compass::Heading turns) {
    return 360.0 * static_cast<double>(compass.normal(compass.start() + turns * compass.turn())) /
           static_cast<double>(compass.order());
}

}  // namespace

TEST_CASE("orders are the common denominator of all headings, and multiples of 4") {
    CHECK(Compass(Drawing{}, 0).order() == 4);
    CHECK(compass("60").order() == 12);
    CHECK(compass("45").order() == 8);
    CHECK(compass("25").order() == 72);
    CHECK(compass("22.5").order() == 16);
    CHECK(compass("90", "30").order() == 12);
    CHECK(compass("90", "0", "45", 1).order() == 8);
    CHECK(compass("90", "0", "45", 2).order() == 4);
    CHECK(compass("0").order() == 4);
}

TEST_CASE("angles with denominators up to 360 are exact, others stand in a table or are rounded") {
    CHECK(compass("1").is_exact());
    CHECK(compass("137.5").is_exact());
    CHECK(!compass("25.7").is_exact());
    CHECK(compass("25.7").order() == 3600);
    CHECK(!irrational(137.50776405).is_exact());
    CHECK(irrational(137.50776405).order() == std::int64_t{1} << 60);
}

TEST_CASE("headings add up, counter-clockwise, from start and spin") {
    CHECK(degrees(compass("60"), 1) == 60);
    CHECK(degrees(compass("-60"), 1) == 300);
    CHECK(degrees(compass("420"), 1) == 60);
    CHECK(degrees(compass("60", "0", "0", 0, true), 1) == 300);
    CHECK(degrees(compass("0", "0", "0", 0, true), 1) == 0);
    CHECK(degrees(compass("90", "-90", "45", 3), 0) == 45);
    CHECK(degrees(compass("90", "0", "45", 1'000'001), 0) == 45);
    CHECK(degrees(compass("90", "0", "45", UINT64_MAX), 0) == 315);
    CHECK(degrees(compass("25.7"), 14) == doctest::Approx(359.8));
}

TEST_CASE("directions on the axes and diagonals are exact, opposite ones exactly opposite") {
    for (const char* angle : {"90", "60", "45", "36", "25", "22.5", "25.7", "1"}) {
        const Compass c = compass(angle);
        CAPTURE(angle);
        const Compass::Heading quarter = c.order() / 4;
        CHECK(c.direction(0) == std::complex<double>(1, 0));
        CHECK(c.direction(quarter) == std::complex<double>(0, 1));
        CHECK(c.direction(2 * quarter) == std::complex<double>(-1, 0));
        CHECK(c.direction(-quarter) == std::complex<double>(0, -1));
        for (Compass::Heading h = 0; h < c.order(); ++h) {
            const auto direction = c.direction(h);
            CHECK(c.direction(h + c.half()) == -direction);
            const long double radians = 2 * std::numbers::pi_v<long double> *
                                        static_cast<long double>(h) /
                                        static_cast<long double>(c.order());
            CHECK(std::abs(std::complex<long double>(direction) - std::polar(1.0L, radians)) <
                  4e-16L);
        }
    }
    CHECK(compass("45").direction(1).real() == compass("45").direction(1).imag());
    CHECK(compass("30").direction(1).imag() == 0.5);
    CHECK(compass("60").direction(2).real() == 0.5);
}

TEST_CASE("rounded headings stay close over many turns") {
    const Compass c = irrational(137.50776405);
    Compass::Heading heading = c.start();
    for (int i = 0; i < 100'000; ++i) heading = c.sum(heading, c.turn());
    const double turned = std::fmod(137.50776405 * 100000, 360.0) * std::numbers::pi / 180;
    CHECK(std::abs(c.direction(heading) - std::polar(1.0, turned)) < 1e-9);
}
