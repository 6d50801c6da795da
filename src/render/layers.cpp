#include "render/layers.hpp"

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

#include "base/error.hpp"

namespace algae {

namespace {

/// The part of a polygon on one side of a line x = bound or y = bound.
template <class Coordinate>
void keep(std::vector<Point>& corners, std::vector<Point>& spare, Coordinate coordinate,
          double bound, double sign) {
    spare.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point a = corners[i], b = corners[(i + 1) % corners.size()];
        const double at_a = sign * (coordinate(a) - bound), at_b = sign * (coordinate(b) - bound);
        if (at_a >= 0) spare.push_back(a);
        const double share = at_a / (at_a - at_b);
        if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0))
            spare.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    }
    corners.swap(spare);
}

}  // namespace

LayerCanvas::LayerCanvas(cairo_surface_t* image, const PixelRectangle& area, const Frame& frame,
                         const Pen& pen, const Budget& budget, const Share& share)
    : image_(image),
      area_(area),
      frame_{frame.scale, frame.x - area.left, frame.y - area.top},
      pen_(pen),
      budget_(budget),
      share_(share),
      width_(pen.width) {
    cairo_surface_flush(image_);
    const cairo_format_t format = cairo_image_surface_get_format(image_);
    pixels_ = cairo_image_surface_get_data(image_);
    stride_ = cairo_image_surface_get_stride(image_);
    if (!pixels_ || (format != CAIRO_FORMAT_ARGB32 && format != CAIRO_FORMAT_RGB24))
        throw Error("the picture cannot be drawn: its pixels are not of 32 bits");
    has_opacity_ = format == CAIRO_FORMAT_ARGB32;
    const auto rows = static_cast<std::size_t>(area.height),
               columns = static_cast<std::size_t>(area.width);
    budget.check_memory(rows * (columns + 2) * sizeof(float), "what a picture's parts cover");
    sums_.assign(rows * (columns + 2), 0);
    first_.assign(rows, area.width);
    last_.assign(rows, -1);
    colour(0);
}

void LayerCanvas::colour(std::uint32_t index) {
    index_ = index;
    painted_.reset();
    colour_ = pen_.palette->colour(pen_.palette->shade(index_, position_));
}

void LayerCanvas::paint(const Colour& colour) {
    painted_ = colour;
    colour_ = colour;
}

void LayerCanvas::position(double fraction) {
    position_ = fraction;
    if (!painted_) colour(index_);
    share_.report(fraction);
}

void LayerCanvas::line_to(Point point) {
    const Point from = here_, to = frame_(point);
    here_ = to;
    ++lines_;
    const double dx = to.x - from.x, dy = to.y - from.y, way = std::hypot(dx, dy),
                 half = width_ / 2;
    const double x = way > 0 ? dx / way : 1, y = way > 0 ? dy / way : 0;
    corners_.clear();
    const auto end = [&](Point at, double ax, double ay) {
        // Half a circle, or for thin strokes, half a square as large.
        constexpr double flat = std::numbers::pi / 4;
        const int parts = pen_.flat_ends ? 1
                          : half < 0.75  ? 1
                                         : static_cast<int>(std::clamp(half * 1.5, 4.0, 40.0));
        const double more = pen_.flat_ends || half >= 0.75 ? 0 : half * flat;
        for (int i = 0; i <= parts; ++i) {
            const double angle = std::numbers::pi * (static_cast<double>(i) / parts - 0.5);
            const double c = parts == 1 ? 0 : std::cos(angle),
                         s = parts == 1 ? (i == 0 ? -1 : 1) : std::sin(angle);
            corners_.push_back({at.x + more * ax + half * (c * ax - s * ay),
                                at.y + more * ay + half * (c * ay + s * ax)});
        }
    };
    end(to, x, y);
    end(from, -x, -y);
    fill(corners_);
    if ((lines_ & 0xfff) == 0) budget_.check();
}

void LayerCanvas::polygon(std::span<const Point> corners) {
    corners_.clear();
    for (const Point& corner : corners) corners_.push_back(frame_(corner));
    fill(corners_);
    if ((++polygons_ & 0xfff) == 0) budget_.check();
}

void LayerCanvas::fill(std::span<const Point> corners) {
    double left = area_.width, right = 0, top = area_.height, bottom = 0;
    for (const Point& corner : corners) {
        if (!std::isfinite(corner.x + corner.y))
            throw Error("the figure has a point whose coordinates are beyond the range of numbers");
        left = std::min(left, corner.x);
        right = std::max(right, corner.x);
        top = std::min(top, corner.y);
        bottom = std::max(bottom, corner.y);
    }
    std::span<const Point> inside = corners;
    if (left < 0 || top < 0 || right > area_.width || bottom > area_.height) {
        if (right <= 0 || bottom <= 0 || left >= area_.width || top >= area_.height) return;
        clipped_.assign(corners.begin(), corners.end());
        const auto x = [](Point p) { return p.x; };
        const auto y = [](Point p) { return p.y; };
        keep(clipped_, clipping_, x, 0, 1);
        keep(clipped_, clipping_, x, area_.width, -1);
        keep(clipped_, clipping_, y, 0, 1);
        keep(clipped_, clipping_, y, area_.height, -1);
        inside = clipped_;
    }
    if (inside.size() < 3) return;
    for (std::size_t i = 0; i < inside.size(); ++i)
        edge(inside[i], inside[(i + 1) % inside.size()]);
    put(std::max(0, static_cast<int>(std::floor(top))),
        std::min(area_.height - 1, static_cast<int>(std::floor(bottom))));
}

/// Adds to each pixel the change of covered area, left to right, that an edge makes.
void LayerCanvas::edge(Point from, Point to) {
    if (from.y == to.y) return;
    const float direction = from.y < to.y ? 1.0f : -1.0f;
    if (from.y > to.y) std::swap(from, to);
    const double slope = (to.x - from.x) / (to.y - from.y), right = area_.width;
    double x = from.x;
    const int last_row = std::min(area_.height, static_cast<int>(std::ceil(to.y)));
    for (int row = static_cast<int>(std::floor(from.y)); row < last_row; ++row) {
        const double upper = std::max<double>(row, from.y), lower = std::min<double>(row + 1, to.y);
        const double after = std::clamp(from.x + slope * (lower - from.y), 0.0, right);
        const auto high = static_cast<float>(lower - upper) * direction;
        const double low_x = std::clamp(std::min(x, after), 0.0, right),
                     high_x = std::clamp(std::max(x, after), 0.0, right);
        x = after;
        const int first = static_cast<int>(low_x), end = static_cast<int>(std::ceil(high_x));
        float* sums = sums_.data() +
                      static_cast<std::size_t>(row) * static_cast<std::size_t>(area_.width + 2);
        const auto at = static_cast<std::size_t>(row);
        first_[at] = std::min(first_[at], first);
        last_[at] = std::max(last_[at], std::max(end, first + 1));
        if (end <= first + 1) {
            const auto share = static_cast<float>((low_x + high_x) / 2 - first);
            sums[first] += high * (1 - share);
            sums[first + 1] += high * share;
            continue;
        }
        // The area left of a slanted edge grows as a parabola in the first and last of its pixels.
        const auto steep = static_cast<float>(1 / (high_x - low_x));
        const auto begins = static_cast<float>(low_x - first),
                   ends = static_cast<float>(high_x - end + 1);
        const float head = 0.5f * steep * (1 - begins) * (1 - begins),
                    tail = 0.5f * steep * ends * ends;
        sums[first] += high * head;
        if (end == first + 2) {
            sums[first + 1] += high * (1 - head - tail);
        } else {
            const float second = steep * (1.5f - begins);
            sums[first + 1] += high * (second - head);
            for (int column = first + 2; column < end - 1; ++column) sums[column] += high * steep;
            const float before = second + static_cast<float>(end - first - 3) * steep;
            sums[end - 1] += high * (1 - before - tail);
        }
        sums[end] += high * tail;
    }
}

/// Mixes the colour into the pixels that the sums of these rows say, and clears the sums.
void LayerCanvas::put(int top, int bottom) {
    const auto part = [](double value) {
        return static_cast<int>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    };
    const int red = part(colour_.red), green = part(colour_.green), blue = part(colour_.blue);
    for (int row = top; row <= bottom; ++row) {
        const auto at = static_cast<std::size_t>(row);
        const int first = first_[at], last = last_[at];
        if (first > last) continue;
        float* sums = sums_.data() + at * static_cast<std::size_t>(area_.width + 2);
        unsigned char* line = pixels_ + static_cast<std::ptrdiff_t>(row + area_.top) * stride_ +
                              4 * static_cast<std::ptrdiff_t>(area_.left);
        float sum = 0;
        for (int column = first; column <= last; ++column) {
            sum += sums[column];
            sums[column] = 0;
            if (column >= area_.width) continue;
            const int covered = std::min(256, static_cast<int>(std::fabs(sum) * 256 + 0.5f));
            if (covered == 0) continue;
            std::uint32_t pixel;
            std::memcpy(&pixel, line + 4 * static_cast<std::ptrdiff_t>(column), sizeof pixel);
            const auto mixed = [covered](std::uint32_t old, int goal) {
                const int was = static_cast<int>(old & 255);
                return static_cast<std::uint32_t>(was + (((goal - was) * covered + 128) >> 8));
            };
            pixel = mixed(pixel, blue) | mixed(pixel >> 8, green) << 8 |
                    mixed(pixel >> 16, red) << 16 |
                    (has_opacity_ ? mixed(pixel >> 24, 255) : 255u) << 24;
            std::memcpy(line + 4 * static_cast<std::ptrdiff_t>(column), &pixel, sizeof pixel);
        }
        first_[at] = area_.width;
        last_[at] = -1;
    }
}

void LayerCanvas::finish() { cairo_surface_mark_dirty(image_); }

}  // namespace algae
