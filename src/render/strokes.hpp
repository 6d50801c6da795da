#pragma once

#include <cstdint>
#include <optional>

#include "base/budget.hpp"
#include "render/layout.hpp"
#include "render/palette.hpp"
#include "turtle/canvas.hpp"

typedef struct _cairo cairo_t;

namespace algae {

/// How strokes look, in the units of the picture.
struct Pen {
    double width = 1;
    bool flat_ends = false;
    const Palette* palette = nullptr;
};

/// Tells a Progress about one figure among several, as often as is good for it.
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

/// Sends a figure to Cairo as it comes. A path is stroked every thousand lines: Cairo's cost for a
/// line grows with the path, and its memory with the figure.
class StrokeCanvas final : public Canvas {
public:
    /// `strokes`: how many are expected, for the progress.
    StrokeCanvas(cairo_t* context, const Frame& frame, const Pen& pen, const Budget& budget,
                 const Share& share, std::optional<std::uint64_t> strokes);

    void move_to(Point point) override;
    void line_to(Point point) override;
    void polygon(std::span<const Point> corners) override;
    void width(double factor) override;
    void width_as_length(double length) override;
    void colour(std::uint32_t index) override;
    void paint(const Colour& colour) override;
    void position(double fraction) override { position_ = fraction; }
    bool wants_position() const override { return along_; }
    double line_width() const override { return pen_.width / frame_.scale; }

    /// Draws what is still held back. Call once, at the end.
    void finish();
    std::uint64_t lines() const { return lines_; }
    std::uint64_t polygons() const { return polygons_; }

private:
    void flush();
    void set_width(double width);
    void choose_shade();

    cairo_t* context_;
    Frame frame_;
    Pen pen_;
    const Budget& budget_;
    Share share_;
    std::optional<std::uint64_t> strokes_;
    bool along_;
    double position_ = 0;
    std::uint32_t colour_ = 0, shade_ = 0;
    std::optional<Colour> painted_;  // instead of a colour of the palette
    Point here_{}, before_{};  // where the pen is and was, in the picture
    bool pen_up_ = true;
    bool goes_on_ = false;  // the next path begins with the last line once more
    std::uint32_t pending_ = 0;
    std::uint64_t lines_ = 0, polygons_ = 0;
};

}  // namespace algae
