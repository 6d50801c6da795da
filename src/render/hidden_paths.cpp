#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/detail/document.hpp"
#include "render/detail/figure_text.hpp"

// What is hidden in a picture of something in space: the paths that later ones cover wherever they are.
//
// Paths are looked at from the last to the first. Each is drawn alone on a mask of four pixels a point, and the pixels that it covers
// wholly are marked. A path is hidden if every pixel that it touches was marked before. Nothing that can be seen is lost: a pixel is
// marked by one path alone, so what lies behind the joint of two is kept.
//
// A path touches the pixels where Cairo gives it some cover, and where it gives it none, as it is too thin, all of the box around it.

namespace algae {

namespace {

constexpr double pixels_a_point = 4;
constexpr int longest_mask = 16'000;  // pixels

/// A rectangle of pixels: from, up to before.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
    bool empty() const { return left >= right || top >= bottom; }
};

/// Draws paths one at a time and remembers which pixels are covered.
class Covers {
public:
    Covers(const Cell& cell, double page, const Budget& budget)
        : cell_(cell), scale_(std::min(pixels_a_point, longest_mask / std::max(page, 1.0))) {
        // What reaches out of the cell, such as half of a stroke, is kept.
        width_ = std::max(1, static_cast<int>(std::ceil(cell.width * scale_)));
        height_ = std::max(1, static_cast<int>(std::ceil(cell.height * scale_)));
        const auto pixels =
            static_cast<std::uint64_t>(width_) * static_cast<std::uint64_t>(height_);
        budget.check_memory(2 * pixels, "what hides what in a figure in space");
        covered_.assign(static_cast<std::size_t>(pixels), 0);
        surface_.reset(cairo_image_surface_create(CAIRO_FORMAT_A8, width_, height_));
        context_.reset(cairo_create(surface_.get()));
        check_cairo(context_.get());
        cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
    }

    /// Whether the path is hidden by those that were added before; then it is not added.
    bool hides(const FigurePath& path, double stroke_width) {
        if (path.points.empty()) return true;
        Box box;
        for (const Point& point : path.points) {
            const Point at = placed(point);
            if (!std::isfinite(at.x + at.y)) return false;
            box.add(at);
        }
        const double reach = path.filled ? 1 : stroke_width * scale_ / 2 + 1;
        if (!(box.low.x - reach >= 0 && box.low.y - reach >= 0 && box.high.x + reach <= width_ &&
              box.high.y + reach <= height_))
            return false;  // it reaches out of the cell
        const PixelBox touched{static_cast<int>(std::floor(box.low.x - reach)),
                               static_cast<int>(std::floor(box.low.y - reach)),
                               static_cast<int>(std::ceil(box.high.x + reach)),
                               static_cast<int>(std::ceil(box.high.y + reach))};
        draw(path, stroke_width);
        const bool hidden = is_hidden(touched);
        leave(touched, !hidden);
        return hidden;
    }

private:
    Point placed(const Point& point) const {
        const Point at = cell_.frame(point);
        return {(at.x - cell_.left) * scale_, (at.y - cell_.top) * scale_};
    }
    void draw(const FigurePath& path, double stroke_width) {
        for (const Point& point : path.points) {
            const Point at = placed(point);
            cairo_line_to(context_.get(), at.x, at.y);
        }
        if (path.filled) {
            cairo_close_path(context_.get());
            cairo_fill(context_.get());
        } else {
            cairo_set_line_width(context_.get(), stroke_width * scale_);
            cairo_stroke(context_.get());
        }
        cairo_surface_flush(surface_.get());
    }
    const unsigned char* drawn(int y) const {
        return cairo_image_surface_get_data(surface_.get()) +
               static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_.get());
    }
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    bool is_hidden(const PixelBox& box) const {
        bool touches = false, all = true;
        for (int y = box.top; y < box.bottom; ++y)
            for (int x = box.left; x < box.right; ++x) {
                const bool covered = covered_[at(x, y)] != 0;
                all = all && covered;
                if (drawn(y)[x] == 0) continue;
                if (!covered) return false;
                touches = true;
            }
        return touches || all;
    }
    /// Wipes the drawing, after its pixels were marked.
    void leave(const PixelBox& box, bool marking) {
        const int stride = cairo_image_surface_get_stride(surface_.get());
        unsigned char* const data = cairo_image_surface_get_data(surface_.get());
        for (int y = box.top; y < box.bottom; ++y)
            for (int x = box.left; x < box.right; ++x) {
                unsigned char& cover = data[static_cast<std::ptrdiff_t>(y) * stride + x];
                if (marking && cover == 255) covered_[at(x, y)] = 1;
                cover = 0;
            }
        cairo_surface_mark_dirty(surface_.get());
    }

    Cell cell_;
    double scale_;
    int width_ = 0, height_ = 0;
    std::vector<unsigned char> covered_;
    OwnedSurface surface_;
    OwnedContext context_;
};

}  // namespace

void leave_out_hidden(FigurePaths& figure, const Cell& cell, const Budget& budget) {
    Covers covers(cell, std::max(cell.width, cell.height), budget);
    std::size_t looked_at = 0;
    for (std::size_t i = figure.paths.size(); i-- > 0;) {
        if ((looked_at++ & 0xff) == 0) budget.check();
        FigurePath& path = figure.paths[i];
        if (!covers.hides(path, figure.styles[path.style].width)) continue;
        if (path.filled)
            --figure.polygons;
        else
            figure.strokes -= path.points.size() - 1;
        path.points.clear();
    }
    std::erase_if(figure.paths, [](const FigurePath& path) { return path.points.empty(); });
}

}  // namespace algae
