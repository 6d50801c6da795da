#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/budget.hpp"
#include "render/cells.hpp"
#include "render/layout.hpp"
#include "render/palette.hpp"
#include "render/strokes.hpp"
#include "turtle/canvas.hpp"

typedef struct _cairo_surface cairo_surface_t;

namespace algae {

/// Draws figures whose parts hide each other on an image: every polygon and every stroke is put over
/// what is there, mixed by the exact share of each pixel that it covers. Many times faster than
/// Cairo for hundreds of thousands of small parts of different colours.
///
/// The route: signed areas to the right of each edge, summed along rows (Levien 2016, font-rs).
class LayerCanvas final : public Canvas {
public:
    /// Draws on an image surface, within `area`; the frame is in its pixels. Throws Error if the
    /// surface has no pixels of 32 bits.
    LayerCanvas(cairo_surface_t* image, const PixelRectangle& area, const Frame& frame,
                const Pen& pen, const Budget& budget, const Share& share);

    void move_to(Point point) override { here_ = frame_(point); }
    void line_to(Point point) override;
    void polygon(std::span<const Point> corners) override;
    void width(double factor) override { width_ = pen_.width * std::fabs(factor); }
    void width_as_length(double length) override { width_ = frame_.scale * length; }
    void colour(std::uint32_t index) override;
    void paint(const Colour& colour) override;
    void position(double fraction) override;
    bool wants_position() const override { return true; }
    double line_width() const override { return pen_.width / frame_.scale; }

    /// Hands the pixels back to Cairo. Call once, at the end.
    void finish();
    std::uint64_t lines() const { return lines_; }
    std::uint64_t polygons() const { return polygons_; }

private:
    /// Fills a polygon given in pixels of the area.
    void fill(std::span<const Point> corners);
    void edge(Point from, Point to);
    void put(int top, int bottom);

    cairo_surface_t* image_;
    PixelRectangle area_;
    Frame frame_;
    Pen pen_;
    const Budget& budget_;
    Share share_;
    unsigned char* pixels_ = nullptr;
    int stride_ = 0;
    bool has_opacity_ = false;
    double position_ = 0, width_;
    std::uint32_t index_ = 0;
    std::optional<Colour> painted_;
    Colour colour_;
    Point here_{};
    std::vector<float> sums_;  // by row of the area and pixel, one more at the end of each row
    std::vector<int> first_, last_;  // by row: the pixels that the sums touch
    std::vector<Point> corners_, clipped_, clipping_;
    std::uint64_t lines_ = 0, polygons_ = 0;
};

}  // namespace algae
