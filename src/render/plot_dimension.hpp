#pragma once

#include <string>

#include "base/budget.hpp"
#include "dimension/fit.hpp"
#include "dimension/scaling.hpp"

namespace algae {

/// What a log-log plot of box counts shows.
struct DimensionPlot {
    std::string caption;  // underneath
    BoxCounts counts;
    BoxFit fit;
};

/// Draws, in the format that the end of the path says, the number of cells against how many of them
/// lie side by side, both logarithmic: the mean over the grids' offsets with its range, the line of
/// the fit with the scales it uses shaded, and underneath by how much each mean is off the line, in per cent.
/// 480 x 420 points (png: 960 x 840 pixels).
///
/// Throws Error if there are fewer than two scales or the file cannot be written.
void draw_dimension_plot(const DimensionPlot& plot, const std::string& path,
                         const Budget& budget = {});

/// What a log-log plot of another measure shows: Richardson's of the lengths that dividers find.
struct ScalingPlot {
    std::string caption;       // underneath
    std::string value, scale;  // what is measured, and what the sizes are: "length", "opening"
    Scaling scaling;
};

/// Draws the values against the coarsest size divided by each, both logarithmic, in the same way;
/// the line is that of least squares through the scales used.
///
/// Throws Error if there are fewer than two scales, if a value is not above 0, or if the file cannot
/// be written.
void draw_scaling_plot(const ScalingPlot& plot, const std::string& path, const Budget& budget = {});

}  // namespace algae
