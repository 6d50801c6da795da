#pragma once

#include "model/model.hpp"
#include "oracle/random_systems.hpp"
#include "oracle/turtle.hpp"
#include "turtle/turtle.hpp"

namespace algae {

/// Any settings a plane turtle may have: exact angles, one in a table (25.7), starts and spins.
inline rc::Gen<oracle::TurtleSettings> any_turtle() {
    using oracle::Fraction;
    static const std::vector<std::pair<long, long>> angles{{90, 1},  {60, 1}, {45, 1}, {36, 1},
                                                           {45, 2},  {20, 1}, {25, 1}, {257, 10},
                                                           {275, 2}, {-30, 1}};
    static const std::vector<std::pair<long, long>> starts{{0, 1}, {90, 1}, {45, 1}, {-60, 1}};
    static const std::vector<std::pair<long, long>> lengths{{1, 1}, {1, 2}, {3, 1}, {1, 3}};
    return rc::gen::apply(
        [](auto angle, auto heading, auto spin, auto step, auto shrink, int x, int y,
           bool clockwise) {
            oracle::TurtleSettings settings;
            settings.angle = {angle.first, angle.second};
            settings.heading = {heading.first, heading.second};
            settings.spin = {spin.first, spin.second};
            settings.step = {step.first, step.second};
            settings.shrink = {shrink.first, shrink.second};
            settings.x = {x, 2};
            settings.y = {y, 3};
            settings.clockwise = clockwise;
            return settings;
        },
        rc::gen::elementOf(angles), rc::gen::elementOf(starts), rc::gen::elementOf(starts),
        rc::gen::elementOf(lengths), rc::gen::elementOf(lengths), rc::gen::inRange(-3, 4),
        rc::gen::inRange(-3, 4), rc::gen::arbitrary<bool>());
}

inline Model drawn_system(const oracle::WrittenSystem& written,
                          const oracle::TurtleSettings& settings) {
    return {oracle::lsystem_of(written), oracle::settings_of(settings), {}, {}};
}

}  // namespace algae
