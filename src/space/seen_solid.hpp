#pragma once

#include <span>

#include "space/lighting.hpp"
#include "space/seen_thing.hpp"

namespace algae {

/// How many flat sides a round solid of this radius has in a picture where details of this size are
/// seen: 8, 16, 32 or 64.
int sides_of(double radius, double resolution);

/// A solid as a camera sees it, in the light. `sides` stand for the roundness of a cylinder or a cone.
SeenThing seen(const Solid& solid, const Colour& colour, int sides, const Projection& projection,
               const Lighting& lighting);

/// A polygon, lit on both sides. `adjoins`: its edges at which another polygon goes on.
SeenThing seen(std::span<const Vector> corners, std::span<const char> adjoins, const Colour& colour,
               const Projection& projection, const Lighting& lighting);

/// Every corner of a box, or points around the circles of a cylinder and a cone, 64 to a circle.
std::vector<Vector> corners_of(const Solid& solid);

}  // namespace algae
