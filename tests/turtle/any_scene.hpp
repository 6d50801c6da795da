#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <numbers>

#include "turtle/turtle.hpp"

namespace algae {

/// A number from `low` to `high`, one of a thousand.
inline double any_number(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000;
}

/// A direction: along an axis half the time, anywhere otherwise.
inline Vector any_direction() {
    const int axis = *rc::gen::inRange(0, 12);
    const double sign = axis % 2 ? 1 : -1;
    if (axis < 2) return {sign, 0, 0};
    if (axis < 4) return {0, sign, 0};
    if (axis < 6) return {0, 0, sign};
    const double z = any_number(-1, 1), angle = any_number(0, 2 * std::numbers::pi);
    const double across = std::sqrt(std::max(0.0, 1 - z * z));
    return {across * std::cos(angle), across * std::sin(angle), z};
}

/// Rods that go on from one another, turn any way and branch; some are lines, some very short.
inline Scene any_rods(std::size_t most) {
    Scene scene;
    scene.name = "a random scene";
    scene.colours = {"black", "red"};
    const auto count = *rc::gen::inRange<std::size_t>(1, most + 1);
    for (std::uint32_t i = 0; i < count; ++i) {
        Rod rod;
        const int kind = *rc::gen::inRange(0, 8);
        if (i > 0 && kind > 0) {
            rod.before = kind < 6 ? i - 1 : *rc::gen::inRange<std::uint32_t>(0, i);
            rod.branch = kind >= 6;
            rod.from = scene.rods[rod.before].to;
        } else {
            rod.from = {any_number(-9, 9), any_number(-9, 9), any_number(-9, 9)};
        }
        const int size = *rc::gen::inRange(0, 10);
        const double far = size == 0 ? 0 : size == 1 ? 1e-3 : any_number(0.1, 5);
        rod.to = rod.from + far * any_direction();
        rod.radius = *rc::gen::inRange(0, 4) == 0 ? 0 : any_number(0.01, 1);
        rod.paint.index = *rc::gen::inRange(0u, 3u);
        scene.rods.push_back(rod);
    }
    return scene;
}

/// A chain of rods of one radius.
inline Scene chain(const std::vector<Vector>& points, double radius) {
    Scene scene;
    scene.name = "a chain";
    for (std::uint32_t i = 0; i + 1 < points.size(); ++i) {
        Rod rod;
        rod.from = points[i];
        rod.to = points[i + 1];
        rod.radius = radius;
        if (i > 0) rod.before = i - 1;
        scene.rods.push_back(rod);
    }
    return scene;
}

}  // namespace algae
