#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "base/budget.hpp"
#include "render/layout.hpp"
#include "render/mask.hpp"
#include "render/palette.hpp"
#include "render/strokes.hpp"
#include "turtle/canvas.hpp"

typedef struct _cairo cairo_t;

namespace algae {

/// A rectangle of whole pixels.
struct PixelRectangle {
    int left = 0, top = 0, width = 0, height = 0;
};

/// Draws a figure that is finer than the pixels: marks cells of a Mask, and paints what was
/// covered wherever colour or width change. O(1) for each short line, O(pixels) for each painting.
class CellCanvas final : public Canvas {
public:
    /// Draws on an image surface, within `area`; the frame is in its pixels.
    CellCanvas(cairo_t* context, const PixelRectangle& area, int cells, const Frame& frame,
               const Pen& pen, const Budget& budget, const Share& share);

    void move_to(Point point) override { mask_.start(frame_(point)); }
    void line_to(Point point) override {
        if (along_) choose_shade();
        mask_.line_to(frame_(point));
        if ((++lines_ & 0xffff) == 0) pause();
    }
    void polygon(std::span<const Point> corners) override;
    void width(double factor) override { set_width(pen_.width * std::fabs(factor) * cells_); }
    void width_as_length(double length) override { set_width(frame_.scale * length); }
    void colour(std::uint32_t index) override;
    void paint(const Colour& colour) override;
    void position(double fraction) override { position_ = fraction; }
    bool wants_position() const override { return along_ || static_cast<bool>(share_); }

    /// Paints what is still held back. Call once, at the end.
    void finish();
    std::uint64_t lines() const { return lines_; }
    std::uint64_t polygons() const { return polygons_; }

private:
    void choose_shade();
    void set_width(double width);  // in cells
    void paint_marks();
    void pause() const;

    cairo_t* context_;
    PixelRectangle area_;
    int cells_;
    Frame frame_;  // to cells of the mask
    Pen pen_;
    const Budget& budget_;
    Share share_;
    bool along_;
    Mask mask_;
    double position_ = 0, width_;
    std::uint32_t colour_ = 0, shade_ = 0;
    std::optional<Colour> painted_;  // instead of a colour of the palette
    std::uint64_t lines_ = 0, polygons_ = 0, paintings_ = 0;
    std::vector<Point> corners_;
};

/// How many cells across a pixel of a mask of this size has: 8, or fewer for large pictures.
int cells_per_pixel(double width, double height);

/// The bytes that drawing in cells takes.
std::uint64_t cells_memory(double width, double height);

}  // namespace algae
