#include "render/strokes.hpp"

#include <cairo.h>

#include <cmath>

#include "render/document.hpp"

namespace algae {
namespace {

constexpr std::uint32_t lines_per_path = 1000;

}  // namespace

StrokeCanvas::StrokeCanvas(cairo_t* context, const Frame& frame, const Pen& pen,
                           const Budget& budget, const Share& share,
                           std::optional<std::uint64_t> strokes)
    : context_(context),
      frame_(frame),
      pen_(pen),
      budget_(budget),
      share_(share),
      strokes_(strokes),
      along_(pen.palette->runs_along()) {
    cairo_new_path(context_);
    cairo_set_line_width(context_, pen_.width);
    cairo_set_line_cap(context_, pen_.flat_ends ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
    shade_ = pen_.palette->shade(0, 0);
    const Colour colour = pen_.palette->colour(shade_);
    cairo_set_source_rgb(context_, colour.red, colour.green, colour.blue);
}

void StrokeCanvas::move_to(Point point) {
    here_ = frame_(point);
    pen_up_ = true;
    goes_on_ = false;
}

void StrokeCanvas::line_to(Point point) {
    if (along_) choose_shade();
    if (pen_up_) {
        if (goes_on_) cairo_move_to(context_, before_.x, before_.y);
        if (goes_on_)
            cairo_line_to(context_, here_.x, here_.y);
        else
            cairo_move_to(context_, here_.x, here_.y);
        pen_up_ = goes_on_ = false;
    }
    before_ = here_;
    here_ = frame_(point);
    cairo_line_to(context_, here_.x, here_.y);
    if (++pending_ == lines_per_path) {
        flush();
        goes_on_ = pen_.flat_ends;  // the next path takes up the last line, so that the join shows
    }
}

/// Strokes the path; the next one starts from here.
void StrokeCanvas::flush() {
    if (pending_ == 0) return;
    lines_ += pending_;
    pending_ = 0;
    pen_up_ = true;
    goes_on_ = false;
    cairo_stroke(context_);
    budget_.check();
    if (share_ && strokes_ && *strokes_ > 0)
        share_.report(static_cast<double>(lines_) / static_cast<double>(*strokes_));
}

void StrokeCanvas::polygon(std::span<const Point> corners) {
    flush();
    choose_shade();
    for (const Point& corner : corners) {
        const Point place = frame_(corner);
        cairo_line_to(context_, place.x, place.y);
    }
    cairo_fill(context_);
    ++polygons_;
    if (polygons_ % lines_per_path == 0) budget_.check();
}

void StrokeCanvas::set_width(double width) {
    flush();
    goes_on_ = false;
    cairo_set_line_width(context_, width);
}

void StrokeCanvas::width(double factor) { set_width(pen_.width * std::fabs(factor)); }

void StrokeCanvas::width_as_length(double length) { set_width(frame_.scale * length); }

void StrokeCanvas::colour(std::uint32_t index) {
    colour_ = index;
    if (painted_) {
        painted_.reset();
        shade_ = Palette::no_shade;
    }
    choose_shade();
}

void StrokeCanvas::paint(const Colour& colour) {
    if (painted_ == colour) return;
    flush();
    goes_on_ = false;
    painted_ = colour;
    cairo_set_source_rgb(context_, colour.red, colour.green, colour.blue);
}

void StrokeCanvas::choose_shade() {
    if (painted_) return;
    const std::uint32_t shade = pen_.palette->shade(colour_, position_);
    if (shade == shade_) return;
    flush();
    goes_on_ = false;
    shade_ = shade;
    const Colour colour = pen_.palette->colour(shade);
    cairo_set_source_rgb(context_, colour.red, colour.green, colour.blue);
}

void StrokeCanvas::finish() {
    flush();
    check_cairo(context_);
}

}  // namespace algae
