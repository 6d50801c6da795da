#pragma once

#include <vector>

#include "shape/box.hpp"
#include "space/scene.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// The boxes that shape rules made, as solids. Their Y is up: X is x, Y is z and Z is -y, as in the
/// documents that draw buildings so. A box has the colour whose number is its symbol's in the
/// alphabet.
///
/// Example: box_scene(read_lsystem("axiom A", ""), {{0, {0, 0, 0}, {1, 2, 3}}}).solids.front().size == Vector{1, 3, 2}
Scene box_scene(const LSystem& system, const std::vector<ShapeBox>& boxes);

}  // namespace algae
