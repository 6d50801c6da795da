#pragma once

#include "render/picture.hpp"
#include "render/plan.hpp"

typedef struct _cairo cairo_t;

namespace algae {

/// The length of a scale bar for a figure so wide: 1, 2 or 5 times a power of ten, about a quarter of it.
///
/// Example: scale_bar_length(90) == 20
/// Example: scale_bar_length(0.3) == 0.05
double scale_bar_length(double breadth);

/// Throws Error if a figure has no scale for the bar that the options ask for, or no place for a label.
void check_annotations(const Plate& plate, const PictureOptions& options);

/// Draws the scale bar below a figure at the left, with its length in the units of the file, and the
/// labels at their points.
void draw_annotations(cairo_t* context, const Plan& plan, const Cell& cell, const Figure& figure);

}  // namespace algae
