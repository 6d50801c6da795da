#pragma once

#include "space/mesh_builder.hpp"

namespace algae {

/// Adds the polygons of a scene as triangles. Equal corners become one point. Where polygons of one
/// paint meet in a point and the angle between them has at least the cosine `crease`, they share
/// one normal there: the sum of theirs, each weighted by its area. Polygons without area are left out.
/// O(corners) expected time, at points where more than 64 polygons meet without smoothing.
void add_sheets(MeshBuilder& builder, const Scene& scene, double crease, const Budget& budget);

}  // namespace algae
