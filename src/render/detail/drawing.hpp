#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "render/detail/layout.hpp"
#include "render/render.hpp"

typedef struct _cairo cairo_t;

namespace algae {

enum class Arrangement { one, pages, panels, frames };

/// Everything about a picture that is decided, and checked, before the first stroke.
struct Plan {
    PictureFormat format = PictureFormat::svg;
    Arrangement arrangement = Arrangement::one;
    PictureOptions options;
    Layout page;        // panels: all cells; pages and frames: a cell for each, all of one size
    double margin = 0;  // around each cell, wide enough for the widest stroke
    std::vector<double> widths;  // of each figure's strokes
    std::optional<Colour> background;
    double font_size = 0;
};

/// Throws Error on options or figures that cannot be drawn, BoundReached if the picture needs more
/// memory than the budget has.
Plan plan(std::span<const Plate> plates, PictureFormat format, Arrangement arrangement,
          const PictureOptions& options, const Budget& budget);

/// Where the text of a label begins that is so wide: to the right of its point and above it, as far as the picture reaches.
Point label_corner(const Plan& plan, Point at, double width);

/// A stroke of a pen of this width that the symbol ! narrows by a factor: it stays wide enough to be seen.
double narrowed(double pen, double factor);

/// The colours that a figure is drawn in: those of the options, or its own.
const std::vector<std::string>& colours_of(const Figure& figure, const PictureOptions& options);

/// Reports the progress of one figure among several.
class Share {
public:
    Share() = default;
    Share(Progress* progress, double from, double to) : progress_(progress), from_(from), to_(to) {}
    void report(double done) const {
        if (progress_) progress_->report(from_ + (to_ - from_) * (done > 1 ? 1 : done));
    }
    explicit operator bool() const { return progress_ != nullptr; }

private:
    Progress* progress_ = nullptr;
    double from_ = 0, to_ = 1;
};

/// A rectangle of whole pixels.
struct PixelRectangle {
    int left = 0, top = 0, width = 0, height = 0;
};

/// Draws a figure in its cell with strokes of this width, by the canvas that suits it. `drawn` records what was drawn.
void draw_figure(cairo_t* context, const Cell& cell, const Plan& plan, const Figure& figure,
                 double width, const Budget& budget, const Share& share, Drawn& drawn);

/// Draws one plate of a plan in its cell: its figure, and its caption below. Adds to `drawn`.
/// Throws what drawing a figure throws.
void draw_plate(cairo_t* context, const Plan& plan, std::size_t i, const Plate& plate,
                const Budget& budget, const Share& share, Drawn& drawn);

/// The share of one figure in the work of a picture, for the progress.
double work(const Figure& figure);

/// The length of a scale bar for a figure so wide: 1, 2 or 5 times a power of ten, about a quarter of it.
///
/// Example: scale_bar_length(90) == 20
/// Example: scale_bar_length(0.3) == 0.05
double scale_bar_length(double breadth);

}  // namespace algae
