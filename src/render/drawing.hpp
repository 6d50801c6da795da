#pragma once

#include <cstddef>

#include "base/budget.hpp"
#include "render/picture.hpp"
#include "render/plan.hpp"
#include "render/strokes.hpp"

namespace algae {

/// Draws one plate of a plan in its cell: its figure, and its caption below. `drawn` learns of it.
/// Throws what drawing a figure throws.
void draw_plate(cairo_t* context, const Plan& plan, std::size_t i, const Plate& plate,
                const Budget& budget, const Share& share, Drawn& drawn);

/// How much of the work of a picture one figure is, for the progress.
double work(const Figure& figure);

}  // namespace algae
