#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <span>
#include <utility>

#include "exact/exact.hpp"
#include "render/detail/document.hpp"
#include "render/detail/drawing.hpp"
#include "render/detail/mask.hpp"
#include "render/detail/palette.hpp"
#include "system/system.hpp"

// How one figure is drawn: three canvases that take the turtle's calls, and the choice between them.
//
// - Strokes: Cairo draws each line and polygon. Its cost for a line grows with the path, and its
//   memory with the figure, so a path is stroked every thousand lines.
// - Cells: a figure that is finer than the pixels marks bits of a Mask, at a few nanoseconds a cell; what was covered is
//   painted whenever colour or width change. What remains of a figure of any length is its pixels.
// - Layers: where parts hide each other (figures in space), each part is mixed into the pixels by the exact share of each pixel that
//   it covers: signed areas to the right of each edge, summed along rows (Levien 2016, font-rs). For hundreds of thousands of
//   small parts of different colours this is many times faster than Cairo.
//
// The choice is made from the format and the number of strokes, before the figure is walked. A png takes layers for a figure whose
// parts hide each other; cells for one with more than 500,000 strokes, with more than 20,000 and more than its pixels, or with a
// number that is not known; otherwise strokes. A vector format takes strokes up to `most_strokes`; a figure with more is drawn
// as an image of 4 pixels a point, in cells or layers, and that is put into the file. `PictureOptions::route` forces strokes or
// cells, except for layers in png.
//
// Subtle: a colour that runs along the word comes in a bounded number of shades, fewer in cells, because each change of shade paints
// the whole mask. Strokes with flat ends begin the next path with the last line once more, so that the join between two paths shows.

namespace algae {

Palette::Palette(const std::vector<std::string>& colours, std::uint32_t hues) : hues_(hues) {
    for (const std::string& text : colours) {
        const bool many = is_scheme(text);
        entries_.push_back({many ? Colour{} : colour_named(text), many ? text : ""});
        runs_along_ = runs_along_ || many;
    }
    if (entries_.empty()) entries_.push_back({});
}

std::uint32_t Palette::shade(std::uint32_t index, double position) const {
    const auto entry = static_cast<std::uint32_t>(index % entries_.size());
    if (entries_[entry].scheme.empty()) return entry;
    const double step = std::clamp(position, 0.0, 1.0) * hues_;
    return static_cast<std::uint32_t>(entries_.size()) + entry * hues_ +
           std::min(static_cast<std::uint32_t>(step), hues_ - 1);
}

Colour Palette::colour(std::uint32_t shade) const {
    if (shade < entries_.size()) return entries_[shade].colour;
    const std::uint32_t beyond = shade - static_cast<std::uint32_t>(entries_.size());
    const std::string& scheme = entries_[beyond / hues_].scheme;
    const double share = static_cast<double>(beyond % hues_);
    // A circle ends where it begins; the others end at their last colour.
    return scheme_colour(scheme, share / (scheme == "along" ? hues_ : std::max(hues_ - 1, 1U)));
}

namespace {

/// How strokes look, in the units of the picture.
struct Pen {
    double width = 1;
    bool flat_ends = false;
    const Palette* palette = nullptr;
};

/// What canvases have in common: a pen that moves in the units of the picture and changes width and colour.
class PenCanvas : public Canvas {
public:
    void width(double factor) final { set_width(narrowed(pen_.width, factor)); }
    void width_as_length(double length) final { set_width(frame_.scale * length); }
    void colour(std::uint32_t index) override {
        index_ = index;
        if (painted_) {
            end_colour();
            painted_.reset();
            shade_ = Palette::no_shade;
        }
        choose_shade();
    }
    void paint(const Colour& colour) override {
        if (painted_ == colour) return;
        end_colour();
        painted_ = colour;
        begin_colour(colour);
    }
    void position(double fraction) override { position_ = fraction; }

    std::uint64_t lines() const { return lines_; }
    std::uint64_t polygons() const { return polygons_; }

protected:
    PenCanvas(const Frame& frame, const Pen& pen, const Budget& budget, const Share& share)
        : frame_(frame),
          pen_(pen),
          budget_(budget),
          share_(share),
          along_(pen.palette->runs_along()),
          shade_(pen.palette->shade(0, 0)) {}

    virtual void set_width(double width) = 0;
    /// Draws what is held back in the colour so far.
    virtual void end_colour() {}
    virtual void begin_colour(const Colour&) {}

    void choose_shade() {
        if (painted_) return;
        const std::uint32_t shade = pen_.palette->shade(index_, position_);
        if (shade == shade_) return;
        end_colour();
        shade_ = shade;
        begin_colour(pen_.palette->colour(shade));
    }

    Frame frame_;
    Pen pen_;
    const Budget& budget_;
    Share share_;
    bool along_;  // whether a colour runs along the word
    double position_ = 0;
    std::uint32_t index_ = 0, shade_ = 0;
    std::optional<Colour> painted_;  // instead of a colour of the palette
    std::uint64_t lines_ = 0, polygons_ = 0;
};

constexpr std::uint32_t lines_per_path = 1000;

/// Sends a figure to Cairo as it comes. A path is stroked every thousand lines: Cairo's cost for a
/// line grows with the path, and its memory with the figure.
class StrokeCanvas final : public PenCanvas {
public:
    /// `strokes`: how many are expected, for the progress.
    StrokeCanvas(cairo_t* context, const Frame& frame, const Pen& pen, const Budget& budget,
                 const Share& share, std::optional<std::uint64_t> strokes)
        : PenCanvas(frame, pen, budget, share), context_(context), strokes_(strokes) {
        cairo_new_path(context_);
        cairo_set_line_width(context_, pen_.width);
        cairo_set_line_cap(context_, pen_.flat_ends ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
        begin_colour(pen_.palette->colour(shade_));
    }

    void move_to(Point point) override {
        here_ = frame_(point);
        pen_up_ = true;
        goes_on_ = false;
    }
    void line_to(Point point) override {
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
            goes_on_ =
                pen_.flat_ends;  // the next path takes up the last line, so that the join shows
        }
    }
    void polygon(std::span<const Point> corners) override {
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
    bool wants_position() const override { return along_; }
    double line_width() const override { return pen_.width / frame_.scale; }

    /// Draws what is still held back. Call once, at the end.
    void finish() {
        flush();
        check_cairo(context_);
    }

private:
    /// Strokes the path; the next one starts from here.
    void flush() {
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
    void set_width(double width) override {
        end_colour();
        cairo_set_line_width(context_, width);
    }
    void end_colour() override {
        flush();
        goes_on_ = false;
    }
    void begin_colour(const Colour& colour) override { set_colour(context_, colour); }

    cairo_t* context_;
    std::optional<std::uint64_t> strokes_;
    Point here_{}, before_{};  // where the pen is and was, in the picture
    bool pen_up_ = true;
    bool goes_on_ = false;  // the next path begins with the last line once more
    std::uint32_t pending_ = 0;
};

/// Draws a figure that is finer than the pixels: marks cells of a Mask, and paints what was
/// covered wherever colour or width change. O(1) for each short line, O(pixels) for each painting.
class CellCanvas final : public PenCanvas {
public:
    /// Draws on an image surface, within `area`; the frame is in its pixels.
    CellCanvas(cairo_t* context, const PixelRectangle& area, int cells, const Frame& frame,
               const Pen& pen, const Budget& budget, const Share& share)
        : PenCanvas(
              {frame.scale * cells, (frame.x - area.left) * cells, (frame.y - area.top) * cells},
              {pen.width * cells, pen.flat_ends, pen.palette}, budget, share),
          context_(context),
          area_(area),
          mask_(area.width, area.height, cells, pen.width * cells),
          width_(pen.width * cells) {}

    void move_to(Point point) override { mask_.start(frame_(point)); }
    void line_to(Point point) override {
        if (along_) choose_shade();
        mask_.line_to(frame_(point));
        if ((++lines_ & 0xffff) == 0) pause();
    }
    void polygon(std::span<const Point> corners) override {
        choose_shade();
        corners_.clear();
        for (const Point& corner : corners) corners_.push_back(frame_(corner));
        mask_.polygon(corners_);
        if ((++polygons_ & 0xfff) == 0) pause();
    }
    bool wants_position() const override { return along_ || static_cast<bool>(share_); }

    /// Paints what is still held back. Call once, at the end.
    void finish() {
        paint_marks();
        check_cairo(context_);
    }

private:
    void set_width(double width) override {  // in cells
        if (width == width_) return;
        paint_marks();
        width_ = width;
        mask_.set_diameter(width);
    }
    void end_colour() override { paint_marks(); }
    void paint_marks() {
        if (mask_.is_blank()) return;
        Mask::Coverage covered = mask_.take();
        set_colour(context_, painted_ ? *painted_ : pen_.palette->colour(shade_));
        cairo_surface_t* surface = cairo_image_surface_create_for_data(
            covered.values.data(), CAIRO_FORMAT_A8, covered.width, covered.height,
            static_cast<int>(covered.stride));
        cairo_mask_surface(context_, surface, area_.left + covered.left, area_.top + covered.top);
        cairo_surface_destroy(surface);
        if ((++paintings_ & 0xff) == 0) pause();
    }
    void pause() const {
        budget_.check();
        share_.report(position_);
    }

    cairo_t* context_;
    PixelRectangle area_;
    Mask mask_;
    double width_;
    std::uint64_t paintings_ = 0;
    std::vector<Point> corners_;
};

/// How many cells across a pixel of a mask of this size has: 8, or fewer for large pictures.
int cells_per_pixel(double width, double height) {
    const double pixels = width * height;
    return pixels <= 8e6 ? 8 : pixels <= 32e6 ? 4 : 2;
}

/// The bytes that drawing in cells takes.
std::uint64_t cells_memory(double width, double height) {
    const double cells = cells_per_pixel(width, height);
    // Bits of the bitmap, and for polygons once more; a byte for each pixel's coverage.
    return static_cast<std::uint64_t>(width * height * (2 * cells * cells / 8 + 1));
}

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

/// Draws figures whose parts hide each other on an image: every polygon and every stroke is put over
/// what is there, mixed by the exact share of each pixel that it covers. Many times faster than
/// Cairo for hundreds of thousands of small parts of different colours.
///
/// The route: signed areas to the right of each edge, summed along rows (Levien 2016, font-rs).
class LayerCanvas final : public PenCanvas {
public:
    /// Draws on an image surface, within `area`; the frame is in its pixels. Throws Error if the
    /// surface has no pixels of 32 bits.
    LayerCanvas(cairo_surface_t* image, const PixelRectangle& area, const Frame& frame,
                const Pen& pen, const Budget& budget, const Share& share)
        : PenCanvas({frame.scale, frame.x - area.left, frame.y - area.top}, pen, budget, share),
          image_(image),
          area_(area),
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

    void move_to(Point point) override { here_ = frame_(point); }
    void line_to(Point point) override {
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
    void polygon(std::span<const Point> corners) override {
        corners_.clear();
        for (const Point& corner : corners) corners_.push_back(frame_(corner));
        fill(corners_);
        if ((++polygons_ & 0xfff) == 0) budget_.check();
    }
    void colour(std::uint32_t index) override {
        index_ = index;
        painted_.reset();
        colour_ = pen_.palette->colour(pen_.palette->shade(index_, position_));
    }
    void position(double fraction) override {
        position_ = fraction;
        if (!painted_) colour(index_);
        share_.report(fraction);
    }
    bool wants_position() const override { return true; }
    double line_width() const override { return pen_.width / frame_.scale; }

    /// Hands the pixels back to Cairo. Call once, at the end.
    void finish() { cairo_surface_mark_dirty(image_); }

private:
    void set_width(double width) override { width_ = width; }
    void begin_colour(const Colour& colour) override { colour_ = colour; }
    /// Fills a polygon given in pixels of the area.
    void fill(std::span<const Point> corners) {
        double left = area_.width, right = 0, top = area_.height, bottom = 0;
        for (const Point& corner : corners) {
            must_be_finite(corner.x + corner.y);
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
    void edge(Point from, Point to) {
        if (from.y == to.y) return;
        const float direction = from.y < to.y ? 1.0f : -1.0f;
        if (from.y > to.y) std::swap(from, to);
        const double slope = (to.x - from.x) / (to.y - from.y), right = area_.width;
        double x = from.x;
        const int last_row = std::min(area_.height, static_cast<int>(std::ceil(to.y)));
        for (int row = static_cast<int>(std::floor(from.y)); row < last_row; ++row) {
            const double upper = std::max<double>(row, from.y),
                         lower = std::min<double>(row + 1, to.y);
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
                for (int column = first + 2; column < end - 1; ++column)
                    sums[column] += high * steep;
                const float before = second + static_cast<float>(end - first - 3) * steep;
                sums[end - 1] += high * (1 - before - tail);
            }
            sums[end] += high * tail;
        }
    }
    /// Mixes the colour into the pixels that the sums of these rows say, and clears the sums.
    void put(int top, int bottom) {
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

    cairo_surface_t* image_;
    PixelRectangle area_;
    unsigned char* pixels_ = nullptr;
    int stride_ = 0;
    bool has_opacity_ = false;
    double width_;
    Colour colour_;
    Point here_{};
    std::vector<float> sums_;  // by row of the area and pixel, one more at the end of each row
    std::vector<int> first_, last_;  // by row: the pixels that the sums touch
    std::vector<Point> corners_, clipped_, clipping_;
};

constexpr double image_resolution = 4;    // pixels a point of an image in a vector format
constexpr double detail_of_layers = 0.5;  // points: how fine a view is in a vector format
constexpr double chord_pixels = 0.35;     // parts of a figure smaller than this become chords
constexpr std::uint64_t few_strokes = 20'000, many_strokes = 500'000;
constexpr std::uint32_t hues = 360, hues_of_cells = 128;

bool is_fine(const Figure& figure, const Frame& frame) {
    const std::optional<std::uint64_t> strokes = figure.strokes();
    if (!strokes || *strokes > many_strokes) return true;
    const double pixels =
        (figure.box().breadth() * frame.scale + 1) * (figure.box().height() * frame.scale + 1);
    return *strokes > few_strokes && static_cast<double>(*strokes) > pixels;
}

/// Draws a figure on a canvas, and counts what was drawn.
template <class AnyCanvas>
void draw_on(AnyCanvas canvas, const Figure& figure, double detail, const Budget& budget,
             Drawn& drawn) {
    figure.draw(canvas, detail, budget);
    canvas.finish();
    drawn.lines += canvas.lines();
    drawn.polygons += canvas.polygons();
}

/// Draws one figure in cells on an image surface.
void draw_cells(cairo_t* context, const PixelRectangle& area, const Frame& frame,
                const Figure& figure, const Pen& pen, const Budget& budget, const Share& share,
                Drawn& drawn) {
    budget.check_memory(cells_memory(area.width, area.height), "a picture drawn in cells");
    const std::optional<std::uint64_t> strokes = figure.strokes();
    const bool join = !strokes || *strokes > many_strokes;
    draw_on(CellCanvas(context, area, cells_per_pixel(area.width, area.height), frame, pen, budget,
                       share),
            figure, join ? chord_pixels / frame.scale : 0, budget, drawn);
}

/// Draws one figure whose parts hide each other on an image surface.
void draw_layers(cairo_t* context, const PixelRectangle& area, const Frame& frame,
                 const Figure& figure, const Pen& pen, const Budget& budget, const Share& share,
                 Drawn& drawn) {
    draw_on(LayerCanvas(cairo_get_target(context), area, frame, pen, budget, share), figure,
            1 / frame.scale, budget, drawn);
}

/// The whole pixels of a cell and its margin, within the picture.
PixelRectangle pixels_of(const Cell& cell, const Plan& plan) {
    const double margin = plan.margin;
    const auto whole = [](double value) { return static_cast<int>(value); };
    PixelRectangle area;
    area.left = whole(std::max(0.0, std::floor(cell.left - margin)));
    area.top = whole(std::max(0.0, std::floor(cell.top - margin)));
    area.width =
        whole(std::min(plan.page.width, std::ceil(cell.left + cell.width + margin))) - area.left;
    area.height =
        whole(std::min(plan.page.height, std::ceil(cell.top + cell.height + margin))) - area.top;
    return area;
}

/// Draws one figure as an image and puts it into a vector format.
void draw_image(cairo_t* context, const Cell& cell, const Plan& plan, const Figure& figure, Pen pen,
                const Budget& budget, const Share& share, Drawn& drawn) {
    const double margin = plan.margin;
    const double more = image_resolution;
    const double width = std::ceil((cell.width + 2 * margin) * more);
    const double height = std::ceil((cell.height + 2 * margin) * more);
    budget.check_memory(static_cast<std::uint64_t>(4 * width * height), "an image in the picture");
    // PostScript has no half-transparent images.
    const bool opaque = plan.format == PictureFormat::ps || plan.format == PictureFormat::eps;
    const OwnedSurface image = blank_image(width, height, opaque);
    const OwnedContext on_image(cairo_create(image.get()));
    if (opaque) {
        set_colour(on_image.get(), plan.background.value_or(Colour{1, 1, 1}));
        cairo_paint(on_image.get());
    }
    const double left = cell.left - margin, top = cell.top - margin;
    const Frame frame{cell.frame.scale * more, (cell.frame.x - left) * more,
                      (cell.frame.y - top) * more};
    pen.width *= more;
    const auto draw = figure.is_layered() ? draw_layers : draw_cells;
    draw(on_image.get(), {0, 0, static_cast<int>(width), static_cast<int>(height)}, frame, figure,
         pen, budget, share, drawn);
    cairo_save(context);
    cairo_translate(context, left, top);
    cairo_scale(context, 1 / more, 1 / more);
    cairo_set_source_surface(context, image.get(), 0, 0);
    cairo_paint(context);
    cairo_restore(context);
    drawn.as_image = true;
}

}  // namespace

double work(const Figure& figure) {
    return 1.0 +
           static_cast<double>(std::min(figure.strokes().value_or(many_strokes), many_strokes));
}

void draw_figure(cairo_t* context, const Cell& cell, const Plan& plan, const Figure& figure,
                 double width, const Budget& budget, const Share& share, Drawn& drawn) {
    using Route = PictureOptions::Route;
    const PictureOptions& options = plan.options;
    const bool pixels = plan.format == PictureFormat::png;
    const std::optional<std::uint64_t> strokes = figure.strokes();
    const bool too_many = !strokes || *strokes > options.most_strokes;
    const bool layered = figure.is_layered();
    const bool fine =
        !(layered && pixels) &&
        (options.route == Route::cells ||
         (options.route == Route::automatic && (pixels ? is_fine(figure, cell.frame) : too_many)));
    const Palette palette(colours_of(figure, options), fine ? hues_of_cells : hues);
    const Pen pen{width, options.flat_ends, &palette};
    drawn.fine = drawn.fine || fine;
    if (layered && pixels) {
        draw_layers(context, pixels_of(cell, plan), cell.frame, figure, pen, budget, share, drawn);
    } else if (fine && pixels) {
        draw_cells(context, pixels_of(cell, plan), cell.frame, figure, pen, budget, share, drawn);
    } else if (fine) {
        draw_image(context, cell, plan, figure, pen, budget, share, drawn);
    } else {
        draw_on(StrokeCanvas(context, cell.frame, pen, budget, share, strokes), figure,
                layered ? detail_of_layers / cell.frame.scale : 0, budget, drawn);
    }
}

}  // namespace algae
