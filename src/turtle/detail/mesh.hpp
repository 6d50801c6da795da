#pragma once
// What the sources of meshes share, and what is measured of a mesh.

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "turtle/turtle.hpp"

namespace algae {

inline bool is_finite(const Vector& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Twice the area of a polygon as a vector, counter-clockwise seen from its tip (Newell's sum). Of a
/// polygon that is not plane, that of the plane on which its projection is largest.
///
/// Example: twice_area(std::vector<Vector>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == Vector{0, 0, 1}
Vector twice_area(std::span<const Vector> corners);

/// Triangles, as corners by number, that fill a polygon with as many sides as it likes, concave or not:
/// corners - 2 of them, fewer where corners lie on one straight line. Of a polygon that is not plane
/// the projection along its Newell normal is triangulated. Where sides cross, the triangles cover what
/// they can. Triangles wind as the polygon does; none is degenerate.
///
/// Ears are cut off one by one (Meisters, Polygons have ears, 1975); a grid over the reflex corners
/// makes that about O(corners) for curves that fill their box evenly, O(corners^2) at worst.
std::vector<std::array<std::uint32_t, 3>> polygon_triangles(std::span<const Vector> corners,
                                                            const Budget& budget);

/// The sum of the areas of all triangles.
///
/// Example: area(Mesh{}) == 0
double area(const Mesh& mesh);

/// What the closed surfaces enclose, each counted on its own even where they overlap.
///
/// Example: volume(Mesh{}) == 0
double volume(const Mesh& mesh);

}  // namespace algae
