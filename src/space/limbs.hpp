#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/budget.hpp"
#include "space/scene.hpp"

namespace algae {

/// How thick things without thickness become where they must have some, and what counts as nothing.
struct Thickness {
    double line = 0;  // the radius of a line of the scene's own width
    double least =
        0;  // the radius of anything thinner; rods shorter than a tenth of it are left out
};

/// Lines become as thick as 1/500 of the diagonal of the box around the scene, or, if that is less,
/// as a quarter of their mean length. Nothing is thinner than a millionth of the largest coordinate
/// or diagonal, which is about what the numbers of single precision in files can tell apart.
Thickness thickness(const Scene& scene);

/// Rods that go on from one another without a gap or a sharp turn, as one bent tube.
struct Limb {
    std::uint32_t first = 0, nodes = 0;  // in Limbs::nodes; at least 2
    bool round_foot = false, round_end = false;
};

/// The limbs of a scene, each a run of nodes.
struct Limbs {
    struct Node {
        Vector point;
        double radius = 0;
        std::uint32_t rod = 0;  // the one that begins here; at the last node the one that ends here
    };
    std::vector<Node> nodes;
    std::vector<Limb> limbs;

    std::span<const Node> nodes_of(const Limb& limb) const {
        return std::span(nodes).subspan(limb.first, limb.nodes);
    }
};

/// Joins the rods of a scene into limbs.
///
/// A rod goes on from the one before it unless it is a branch (or is the only rod there). At the joint
/// both have the radius of the one that goes on. A limb ends flat where nothing is to be hidden. Its
/// end is round where branches begin and nothing goes on, at turns of more than 120 degrees, and where
/// a mitre would cut away more than half of a rod; its foot is round where it is wider than what it
/// begins in. Rods in one straight line of one radius and paint become one piece.
///
/// Throws Error if a coordinate or radius is not finite. O(rods) time and memory.
Limbs limbs_of(const Scene& scene, const Thickness& thickness, const Budget& budget);

/// Whether a limb is one straight piece of one radius that ends flat at both ends.
bool is_cylinder(const Limbs& limbs, const Limb& limb);

}  // namespace algae
