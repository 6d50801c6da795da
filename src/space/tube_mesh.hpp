#pragma once

#include <span>

#include "space/limbs.hpp"
#include "space/mesh_builder.hpp"

namespace algae {

/// Adds a limb as a closed tube: a ring of points at each node, in the plane of the mitre where it
/// turns. `crease` is the cosine of the largest turn that is shaded smoothly.
void add_tube(MeshBuilder& builder, std::span<const Limbs::Node> nodes, const Limb& limb,
              const Scene& scene, const Circle& circle, double crease);

/// How many triangles and, at most, corners such a tube has.
struct TubeSize {
    std::uint64_t triangles = 0, corners = 0, points = 0;
};
TubeSize tube_size(const Limb& limb, unsigned sides);

}  // namespace algae
