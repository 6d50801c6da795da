#pragma once

#include <cstdint>

#include "turtle/canvas.hpp"

namespace algae {

/// Where Brownian motion from `from`, outside of the circle of this radius around the origin, first
/// meets the circle, by a random number: with the Poisson kernel, whose angle from that of `from` is
/// twice the arc tangent of (d - r) / (d + r) tan(pi (u - 1/2)), d being the distance from the origin
/// (Kaufman, Vespignani, Mandelbrot and Woog, Physical Review E 52, 1995). It always comes back.
///
/// Example: return_to_circle({3, 0}, 1, std::uint64_t{1} << 63).x > 0.999
Point return_to_circle(Point from, double radius, std::uint64_t number);

}  // namespace algae
