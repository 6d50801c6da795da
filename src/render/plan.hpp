#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "render/layout.hpp"
#include "render/picture.hpp"

namespace algae {

enum class Arrangement { one, pages, panels, frames };

/// Everything about a picture that is decided, and checked, before the first stroke.
struct Plan {
    PictureFormat format = PictureFormat::svg;
    Arrangement arrangement = Arrangement::one;
    PictureOptions options;
    Layout page;                 // panels: all cells; pages and frames: a cell for each, all of one size
    double margin = 0;           // around each cell, wide enough for the widest stroke
    std::vector<double> widths;  // of each figure's strokes
    std::optional<Colour> background;
    double font_size = 0;
};

/// Throws Error on options or figures that cannot be drawn, BoundReached if the picture needs more
/// memory than the budget has.
Plan plan(std::span<const Plate> plates, PictureFormat format, Arrangement arrangement,
          const PictureOptions& options, const Budget& budget);

/// The colours that a figure is drawn in: those of the options, or its own.
const std::vector<std::string>& colours_of(const Figure& figure, const PictureOptions& options);

}  // namespace algae
