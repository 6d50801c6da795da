#include "turtle/detail/view.hpp"
#include "turtle/turtle.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "exact/exact.hpp"
#include "oracle/ray_caster.hpp"

using namespace algae;

namespace {

double between(int low, int high) { return *rc::gen::inRange(low * 1000, high * 1000) / 1000.0; }

}  // namespace

TEST_CASE("the named directions of the camera") {
    SpaceBox box;
    box.add(Vector{0, 0, 0});
    box.add(Vector{1, 1, 1});
    const Projection front(Camera{-90, 0}, box), above(Camera{-90, 90}, box);
    const Seen one = front({1, 2, 3}), other = above({1, 2, 3});
    CHECK(one.x == 1);
    CHECK(one.y == 3);
    CHECK(one.depth == -2);
    CHECK(other.x == 1);
    CHECK(other.y == 2);
    CHECK(other.depth == 3);
}

TEST_CASE("a projection is what plain matrices give") {
    CHECK(rc::check([] {
        Camera camera{between(-400, 400), between(-90, 90), *rc::gen::arbitrary<bool>(),
                      between(1, 120)};
        SpaceBox box;
        box.add(Vector{between(-5, 0), between(-5, 0), between(-5, 0)});
        box.add(Vector{between(1, 9), between(1, 9), between(1, 9)});
        const Projection projection(camera, box);
        oracle::Eye eye;
        eye.azimuth = camera.azimuth;
        eye.elevation = camera.elevation;
        eye.opening = camera.perspective ? camera.opening : 0;
        eye.middle = {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2,
                      (box.low.z + box.high.z) / 2};
        eye.radius =
            std::sqrt(std::pow(box.high.x - box.low.x, 2) + std::pow(box.high.y - box.low.y, 2) +
                      std::pow(box.high.z - box.low.z, 2)) /
            2;
        const Vector point{between(0, 1), between(0, 1), between(0, 1)};
        const Seen seen = projection(point);
        const auto expected = oracle::seen_by_matrices(eye, {point.x, point.y, point.z});
        RC_ASSERT(std::fabs(seen.x - expected[0]) < 1e-9);
        RC_ASSERT(std::fabs(seen.y - expected[1]) < 1e-9);
    }));
}

TEST_CASE("straight lines stay straight, in depth too") {
    CHECK(rc::check([] {
        SpaceBox box;
        box.add(Vector{-1, -1, -1});
        box.add(Vector{1, 1, 1});
        const Projection projection(
            Camera{between(-180, 180), between(-90, 90), true, between(5, 120)}, box);
        const Vector a{between(-1, 1), between(-1, 1), between(-1, 1)},
            b{between(-1, 1), between(-1, 1), between(-1, 1)};
        const Seen p = projection(a), q = projection(b), m = projection(0.5 * (a + b));
        const Vector pq{q.x - p.x, q.y - p.y, q.depth - p.depth},
            pm{m.x - p.x, m.y - p.y, m.depth - p.depth};
        RC_ASSERT(length(cross(pq, pm)) < 1e-9 * (1 + dot(pq, pq)));
    }));
}

TEST_CASE("cameras and lights out of bounds") {
    CHECK_THROWS_WITH_AS(check_camera(Camera{0, 91}),
                         "the camera's elevation is 91 degrees, expected -90 to 90", Error);
    CHECK_THROWS_WITH_AS(check_camera(Camera{0, 0, true, 0.5}),
                         "the camera's opening is 0.5 degrees, expected 1 to 170", Error);
    CHECK_THROWS_WITH_AS(check_camera(Camera{std::nan(""), 0}),
                         "the camera's azimuth is not a finite number of degrees", Error);
    CHECK_THROWS_AS(check_light(Light{0, -100}), Error);
    CHECK_THROWS_AS(Lighting({0, 0}, 1.5, {}, 0, 1), Error);
    CHECK_NOTHROW(check_camera(Camera{0, -90}));
}

TEST_CASE("fog takes what is far towards the background") {
    const Lighting lighting({0, 0}, 0.5, {1, 1, 1}, -2, 2);
    const Colour near = lighting.at_depth({0, 0, 0}, 2), middle = lighting.at_depth({0, 0, 0}, 0),
                 far = lighting.at_depth({0, 0, 0}, -2);
    CHECK(near == Colour{0, 0, 0});
    CHECK(middle.red == doctest::Approx(0.25));
    CHECK(far.red == doctest::Approx(0.5));
    // What the light meets is brighter than what it does not.
    CHECK(Lighting::lit({0.5, 0.5, 0.5}, 1).red > Lighting::lit({0.5, 0.5, 0.5}, 0).red);
    CHECK(Lighting::lit({0.5, 0.5, 0.5}, 0).red > Lighting::lit({0.5, 0.5, 0.5}, -1).red);
}
