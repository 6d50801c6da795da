#include "turtle/turtle.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace algae;

TEST_CASE("turns by multiples of 90 degrees are exact") {
    for (int quarters = -9; quarters <= 9; ++quarters) {
        const Turn turn = turn_by(90.0 * quarters);
        const int side = ((quarters % 4) + 4) % 4;
        CHECK(turn.cosine == (side == 0 ? 1 : side == 2 ? -1 : 0));
        CHECK(turn.sine == (side == 1 ? 1 : side == 3 ? -1 : 0));
    }
    CHECK(turn_by(150).sine == 0.5);
    CHECK(turn_by(-60).cosine == 0.5);
    CHECK(turn_by(135).sine == -turn_by(135).cosine);
    for (double degrees = -800; degrees < 800; degrees += 7.3) {
        CHECK(turn_by(degrees).sine == doctest::Approx(std::sin(degrees * std::numbers::pi / 180)));
        CHECK(turn_by(degrees).cosine ==
              doctest::Approx(std::cos(degrees * std::numbers::pi / 180)));
        CHECK(turn_by(-degrees).sine == -turn_by(degrees).sine);
    }
}

TEST_CASE("the commands turn the way they are called") {
    const Turn quarter = turn_by(90);
    const Attitude start;
    Attitude turned = start;
    turned.yaw(quarter);
    CHECK(turned.heading() == start.left());
    turned = start;
    turned.pitch(quarter);
    CHECK(turned.heading() == Vector{0, 0, -1});  // down
    turned = start;
    turned.roll(quarter);
    CHECK(turned.left() == Vector{0, 0, -1});  // the left side sinks
    turned = start;
    turned.turn_back();
    CHECK(turned.heading() == Vector{-1, 0, 0});
    CHECK(turned.up() == start.up());
}

TEST_CASE("a million turns leave the vectors orthonormal, quarters of turns exactly") {
    std::mt19937_64 numbers(7);
    Attitude any, quarters;
    for (int i = 0; i < 1'000'000; ++i) {
        const auto number = numbers();
        const Turn turn = turn_by(static_cast<double>(number % 3600) / 10 + 0.05);
        const Turn quarter = turn_by(90.0 * static_cast<double>(number >> 60));
        switch (number / 4096 % 3) {
            case 0:
                any.yaw(turn), quarters.yaw(quarter);
                break;
            case 1:
                any.pitch(turn), quarters.pitch(quarter);
                break;
            default:
                any.roll(turn), quarters.roll(quarter);
                break;
        }
    }
    CHECK(std::fabs(dot(any.heading(), any.left())) < 1e-12);
    CHECK(std::fabs(dot(any.heading(), any.up())) < 1e-12);
    CHECK(std::fabs(length(any.heading()) - 1) < 1e-12);
    CHECK(length(cross(any.heading(), any.left()) - any.up()) < 1e-12);
    CHECK(dot(quarters.heading(), quarters.left()) == 0);
    CHECK(dot(quarters.heading(), quarters.heading()) == 1);
    CHECK(cross(quarters.heading(), quarters.left()) == quarters.up());
}

TEST_CASE("levelling lays left into the plane and keeps the heading") {
    Attitude attitude;
    attitude.yaw(turn_by(30));
    attitude.pitch(turn_by(-50));
    attitude.roll(turn_by(110));
    const Vector heading = attitude.heading();
    REQUIRE(attitude.level());
    CHECK(attitude.heading() == heading);
    CHECK(attitude.left().z == 0);
    CHECK(attitude.up().z > 0);
    CHECK(std::fabs(dot(attitude.left(), heading)) < 1e-15);
    Attitude upright;
    upright.pitch(turn_by(-90));
    CHECK_FALSE(upright.level());
}
