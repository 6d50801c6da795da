#include "nature/circle_return.hpp"

#include <cmath>
#include <numbers>

#include "nature/gaussian.hpp"

namespace algae {

Point return_to_circle(Point from, double radius, std::uint64_t number) {
    const double distance = std::hypot(from.x, from.y);
    const double slope = (distance - radius) / (distance + radius) *
                         std::tan(std::numbers::pi * (unit_interval(number) - 0.5));
    // The turn by twice the angle with this tangent.
    const double cosine = (1 - slope * slope) / (1 + slope * slope);
    const double sine = 2 * slope / (1 + slope * slope);
    const double scale = radius / distance;
    return {scale * (from.x * cosine - from.y * sine), scale * (from.x * sine + from.y * cosine)};
}

}  // namespace algae
