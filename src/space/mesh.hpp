#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "space/scene.hpp"

namespace algae {

/// A scene as triangles.
///
/// First come closed surfaces, each wound counter-clockwise seen from outside: every directed edge
/// between points is in one triangle and its reverse in one. Then come sheets, the polygons of the
/// scene, to be seen from both sides.
struct Mesh {
    /// A corner of triangles: where it is, which way its surface looks there, what it is painted
    /// with. Several corners share a point where the surface has an edge or changes its paint.
    struct Corner {
        std::uint32_t point = 0;  // in `points`
        std::uint32_t paint = 0;  // in `paints`
        Vector normal;            // of length 1
    };
    using Triangle = std::array<std::uint32_t, 3>;  // in `corners`

    std::vector<Vector> points;
    std::vector<Corner> corners;
    std::vector<Triangle> triangles;
    std::size_t closed = 0;  // so many of the triangles, from the first, belong to closed surfaces
    std::vector<Paint> paints;

    const Vector& place(std::uint32_t corner) const { return points[corners[corner].point]; }
};

struct MeshOptions {
    /// Sides of a tube, from 3 to 256; a solid that is round has twice as many.
    unsigned facets = 8;
    /// Surfaces that meet at less than this angle, in degrees, are shaded as one smooth surface.
    double crease = 40;
    /// Whether rods that are cylinders (see is_cylinder) and solids become triangles too.
    bool cylinders = true, solids = true;
};

/// The triangles of a scene.
///
/// Rods that go on from one another become one tube (see Limbs) whose cross section is carried along
/// without twist (the rotation-minimising frame: reflections in the planes of the mitres, after Wang
/// et al., Computation of rotation minimizing frames, 2008), narrowing along each rod to the width
/// of the next, with mitred joints and closed ends. A tube is inscribed in the round one: k facets
/// hold k/(2 pi) sin(2 pi/k) of its volume. Rods without radius and measures of 0 of solids become
/// as thick as `thickness` says. Polygons are triangulated as `polygon_triangles` does; those with
/// a common corner are smooth there unless they meet at an edge sharper than the crease.
///
/// Throws Error on options out of range, on coordinates or measures that are not finite, and if there
/// is nothing to be seen; BoundReached if the mesh would have 2^32 corners or need more memory
/// than the budget has, before it is built. O(rods * facets) time.
Mesh mesh_of(const Scene& scene, const MeshOptions& options, const Budget& budget);

/// The box around all points.
SpaceBox box_of(const Mesh& mesh);

/// The sum of the areas of all triangles.
///
/// Example: area(Mesh{}) == 0
double area(const Mesh& mesh);

/// What the closed surfaces enclose, each counted on its own even where they overlap.
///
/// Example: volume(Mesh{}) == 0
double volume(const Mesh& mesh);

}  // namespace algae
