#pragma once

#include "space/mesh_builder.hpp"
#include "space/tube_mesh.hpp"

namespace algae {

/// Adds a solid as a closed surface; measures of 0 become as thick as a line. Spheres have circles of
/// latitude at half as many angles as `circle` has corners.
void add_solid(MeshBuilder& builder, const Solid& solid, const Circle& circle,
               const Thickness& thickness);

/// How many triangles and, at most, corners such a solid has.
TubeSize solid_size(SolidShape shape, unsigned sides);

}  // namespace algae
