#include "render/cells.hpp"

#include <cairo.h>

#include <cmath>

#include "render/document.hpp"

namespace algae {

CellCanvas::CellCanvas(cairo_t* context, const PixelRectangle& area, int cells, const Frame& frame,
                       const Pen& pen, const Budget& budget, const Share& share)
    : context_(context),
      area_(area),
      cells_(cells),
      frame_{frame.scale * cells, (frame.x - area.left) * cells, (frame.y - area.top) * cells},
      pen_(pen),
      budget_(budget),
      share_(share),
      along_(pen.palette->runs_along()),
      mask_(area.width, area.height, cells, pen.width * cells),
      width_(pen.width * cells) {
    shade_ = pen_.palette->shade(0, 0);
}

void CellCanvas::polygon(std::span<const Point> corners) {
    choose_shade();
    corners_.clear();
    for (const Point& corner : corners) corners_.push_back(frame_(corner));
    mask_.polygon(corners_);
    if ((++polygons_ & 0xfff) == 0) pause();
}

void CellCanvas::set_width(double width) {
    if (width == width_) return;
    paint_marks();
    width_ = width;
    mask_.set_diameter(width);
}

void CellCanvas::colour(std::uint32_t index) {
    colour_ = index;
    if (painted_) {
        paint_marks();
        painted_.reset();
    }
    choose_shade();
}

void CellCanvas::paint(const Colour& colour) {
    if (painted_ == colour) return;
    paint_marks();
    painted_ = colour;
}

void CellCanvas::choose_shade() {
    if (painted_) return;
    const std::uint32_t shade = pen_.palette->shade(colour_, position_);
    if (shade == shade_) return;
    paint_marks();
    shade_ = shade;
}

void CellCanvas::pause() const {
    budget_.check();
    share_.report(position_);
}

void CellCanvas::paint_marks() {
    if (mask_.is_blank()) return;
    Mask::Coverage covered = mask_.take();
    const Colour colour = painted_ ? *painted_ : pen_.palette->colour(shade_);
    cairo_set_source_rgb(context_, colour.red, colour.green, colour.blue);
    cairo_surface_t* surface =
        cairo_image_surface_create_for_data(covered.values.data(), CAIRO_FORMAT_A8, covered.width,
                                            covered.height, static_cast<int>(covered.stride));
    cairo_mask_surface(context_, surface, area_.left + covered.left, area_.top + covered.top);
    cairo_surface_destroy(surface);
    if ((++paintings_ & 0xff) == 0) pause();
}

void CellCanvas::finish() {
    paint_marks();
    check_cairo(context_);
}

int cells_per_pixel(double width, double height) {
    const double pixels = width * height;
    return pixels <= 8e6 ? 8 : pixels <= 32e6 ? 4 : 2;
}

std::uint64_t cells_memory(double width, double height) {
    const double cells = cells_per_pixel(width, height);
    // Bits of the bitmap, and for polygons once more; a byte for each pixel's coverage.
    return static_cast<std::uint64_t>(width * height * (2 * cells * cells / 8 + 1));
}

}  // namespace algae
