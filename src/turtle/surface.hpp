#pragma once

#include <vector>

#include "system/space_settings.hpp"
#include "turtle/pose.hpp"

namespace algae {

/// The flat polygons of a surface, their points along heading, left and up of the turtle, in steps.
///
/// - A leaf begins where the turtle stands, points along the heading, is 1 long and 2/5 wide.
/// - A petal begins there too, is 1 long and 3/5 wide, widest near its round end.
/// - A disc has its middle there and the diameter 1.
/// - A polygon is itself. A patch is a bicubic Bezier surface over four rows of four points (Foley and
///   others 1990, 11.3), as 72 triangles.
///
/// Example: surface_faces({0, "disc", {}}).front().front() == Vector{0.5, 0, 0}
std::vector<std::vector<Vector>> surface_faces(const SurfaceSetting& surface);

/// Whether all of it lies in the plane of heading and left.
bool is_flat(const SurfaceSetting& surface);

}  // namespace algae
