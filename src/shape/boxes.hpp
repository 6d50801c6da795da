#pragma once

#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "shape/shape_system.hpp"

namespace algae {

/// What the rules make of one box that stands alone, or the box itself where none applies. The parts of div along
/// several axes stand in the order of the places, those of the last axis named running fastest.
/// Throws Error, with the rule's place and the box, if sizes do not fit the box or are not above 0,
/// if they or the condition have no value, or if two rules apply.
std::vector<ShapeBox> parts_of(const ShapeSystem& system, const ShapeBox& box,
                               const Budget& budget = {});

/// The boxes after n more steps, in each of which every box is replaced by its parts. Stops early
/// when no rule applies any more. Linear in the number of all boxes on the
/// way, with a sort of each generation where conditions ask for distances. Throws Error as
/// parts_of does, BoundReached if there are more boxes than the budget's letters or memory allow.
std::vector<ShapeBox> boxes_after(const ShapeSystem& system, std::vector<ShapeBox> boxes,
                                  std::uint64_t n, const Budget& budget = {});

}  // namespace algae
