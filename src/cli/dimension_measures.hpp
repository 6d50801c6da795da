#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "dimension/generalised.hpp"
#include "dimension/points.hpp"
#include "dimension/scaling.hpp"

namespace algae::cli {

/// The measures beside boxes, as --measure names them.
inline constexpr const char* measure_help =
    "boxes (default), divider (lengths by dividers), mass (what lies within discs), correlation "
    "(pairs of points), information and multifractal (shares of boxes), lacunarity (gaps)";

inline constexpr const char* measure_type =
    "boxes|divider|mass|correlation|information|multifractal|lacunarity";

/// Throws Error unless it names a measure, boxes among them.
void check_measure(const std::string& measure);

/// What one of these measures found.
struct OtherMeasured {
    std::string what, measure;
    Scaling scaling;
    std::vector<GeneralisedDimension> spectrum;  // of the measure multifractal only
};

/// Boxes are counted in so many grids. Throws Error if the measure is
/// not for such an input.
OtherMeasured measured_otherwise(const std::string& measure, std::string what, const Figure& figure,
                                 std::size_t grids, const Budget& budget);
OtherMeasured measured_otherwise(const std::string& measure, std::string what,
                                 const PointSet& points, std::size_t grids, const Budget& budget);

/// Throws Error unless a log-log plot of this measure shows its dimension.
void check_plotted(const std::string& measure);
/// Draws that plot, in the format that the end of the path says.
void plot_measured(const OtherMeasured& found, const std::string& path, const Budget& budget);

/// Prints it, as a page or as JSON, and gives how the command ends.
int print_measured(const OtherMeasured& found, bool json);

}  // namespace algae::cli
