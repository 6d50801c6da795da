#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "system/d0l.hpp"

namespace algae {

/// A diagram of one sequence: dots, and a line through what a formula gives.
struct Plot {
    std::string caption;       // underneath
    std::string formula;       // beside the line; may be empty
    std::string horizontal;    // what the axes show
    std::string vertical;
    bool logarithmic = false;  // then all heights are decimal logarithms
    std::vector<std::pair<double, double>> dots;
    std::vector<std::pair<double, double>> line;
};

/// Draws it, in the format that the end of the path says, 480 x 320 points (png: 960 x 640 pixels).
/// Throws Error if nothing can be drawn or the file cannot be written.
void draw_plot(const Plot& plot, const std::string& path, const Budget& budget = {});

/// Length against generation, from `first` to `last`: dots are exact lengths, the line is the closed
/// form; logarithmic where the growth is exponential.
Plot growth_plot(const D0L& system, std::uint64_t first, std::uint64_t last, const Budget& budget = {});

}  // namespace algae
