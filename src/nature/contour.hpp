#pragma once

#include <vector>

#include "base/budget.hpp"
#include "dimension/divider.hpp"
#include "nature/height_field.hpp"

namespace algae {

/// The lines on which a surface has this height, in the unit square: on each edge of the grid whose
/// ends are below and not below, the point in proportion; joined within each square, as the mean of
/// its corners says where there are two ways (marching squares: Lorensen and Cline, Computer Graphics
/// 21, 1987, for cubes). Lines that close end where they begin; others begin and end at the border.
/// What is not below lies to their left. O(points).
///
/// Throws BoundReached, Interrupted.
std::vector<Stroke> contour_lines(const HeightField& field, double height, const Budget& budget);

}  // namespace algae
