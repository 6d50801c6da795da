#include "render/detail/mask.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "exact/exact.hpp"
#include "render/figures.hpp"
#include "render/pixels.hpp"
#include "render/render.hpp"

using namespace algae;
using namespace algae::test;

namespace {

void line(Mask& mask, Point from, Point to) {
    mask.start(from);
    mask.line_to(to);
}

/// The sum of all coverages, in pixels.
double area(const Mask::Coverage& covered) {
    double sum = 0;
    for (const unsigned char value : covered.values) sum += value / 255.0;
    return sum;
}

/// A figure that does not say how many strokes it has, so that it is drawn in chords.
class Endless : public DrawnFigure {
public:
    explicit Endless(const DrawnFigure& figure) : DrawnFigure(figure) {}
    std::optional<std::uint64_t> strokes() const override { return std::nullopt; }
};

Pixels drawn(const Figure& figure, int width, double line_width, PictureOptions::Route route) {
    PictureOptions options;
    options.width = width;
    options.margin = 3;
    options.line_width = line_width;
    options.route = route;
    std::ostringstream png;
    draw_picture({&figure, "the dragon", ""}, png, PictureFormat::png, options, Budget{});
    return Pixels(png.str());
}

/// One path of all lines, stroked by Cairo at once: no code is shared with the pictures.
Pixels brute_force(const Figure& figure, const Pixels& like, double line_width) {
    struct Path : Canvas {
        void move_to(Point point) override {
            cairo_move_to(context, x + scale * point.x, y - scale * point.y);
        }
        void line_to(Point point) override {
            cairo_line_to(context, x + scale * point.x, y - scale * point.y);
        }
        void polygon(std::span<const Point>) override {}
        void width(double) override {}
        void width_as_length(double) override {}
        void colour(std::uint32_t) override {}
        void position(double) override {}
        cairo_t* context = nullptr;
        double scale = 1, x = 0, y = 0;
    };
    cairo_surface_t* image =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, like.width, like.height);
    Path path;
    path.context = cairo_create(image);
    cairo_set_source_rgb(path.context, 1, 1, 1);
    cairo_paint(path.context);
    cairo_set_source_rgb(path.context, 0, 0, 0);
    cairo_set_line_width(path.context, line_width);
    cairo_set_line_cap(path.context, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(path.context, CAIRO_LINE_JOIN_ROUND);
    path.scale = (like.width - 6) / figure.box().breadth();
    path.x = 3 - path.scale * figure.box().low.x;
    path.y = 3 + path.scale * figure.box().high.y;
    figure.draw(path, 0, Budget{});
    cairo_stroke(path.context);
    cairo_destroy(path.context);
    Pixels pixels(image);
    cairo_surface_destroy(image);
    return pixels;
}

}  // namespace

TEST_CASE("a line covers its length times its width") {
    for (const double width : {1.0, 2.0, 2.5, 4.0, 7.0, 8.0, 16.0, 33.0}) {
        CAPTURE(width);
        Mask mask(100, 100, 8, width);
        line(mask, {200, 403}, {600, 403});
        const double expected = (400 * width + width * width * 0.785) / 64;
        CHECK(std::fabs(area(mask.take()) - expected) < 0.02 * expected + 400 * 0.5 / 64);
        line(mask, {200, 203}, {500, 603});  // 3, 4, 5
        const double slanted = (500 * width + width * width * 0.785) / 64;
        CHECK(std::fabs(area(mask.take()) - slanted) < 0.03 * slanted + 500 * 0.5 / 64);
    }
}

TEST_CASE("a bitmap that was taken is blank") {
    Mask mask(10, 10, 8, 3);
    CHECK(mask.is_blank());
    line(mask, {8, 8}, {40, 40});
    mask.polygon(std::vector<Point>{{0, 0}, {16, 0}, {16, 16}});
    CHECK_FALSE(mask.is_blank());
    CHECK(area(mask.take()) > 0);
    CHECK(mask.is_blank());
    CHECK(mask.take().values.empty());
}

TEST_CASE("a polygon covers its area, wherever it is cut off") {
    for (const int cells : {2, 4, 8}) {
        Mask mask(40, 40, cells, 1);
        const double c = cells;
        mask.polygon(
            std::vector<Point>{{5 * c, 5 * c}, {25 * c, 5 * c}, {25 * c, 15 * c}, {5 * c, 15 * c}});
        const Mask::Coverage covered = mask.take();
        CHECK(covered.left == 5);
        CHECK(covered.top == 5);
        CHECK(covered.width == 20);
        CHECK(covered.height == 10);
        CHECK(area(covered) == doctest::Approx(200));
        mask.polygon(std::vector<Point>{
            {-10 * c, -10 * c}, {10 * c, -10 * c}, {10 * c, 50 * c}, {-10 * c, 50 * c}});
        CHECK(area(mask.take()) == doctest::Approx(400));
    }
}

TEST_CASE("lines that leave the bitmap are cut off, and points that are no numbers refused") {
    CHECK(rc::check("cut lines stay inside", [] {
        Mask mask(20, 15, 4, 3);
        const auto coordinate = [] { return *rc::gen::inRange(-500, 500) / 3.0; };
        line(mask, {coordinate(), coordinate()}, {coordinate(), coordinate()});
        const Mask::Coverage covered = mask.take();
        RC_ASSERT(covered.left >= 0 && covered.left + covered.width <= 20);
        RC_ASSERT(covered.top >= 0 && covered.top + covered.height <= 15);
    }));
    Mask mask(20, 15, 4, 3);
    line(mask, {-100, 30}, {200, 30});
    CHECK(area(mask.take()) == doctest::Approx(20 * 0.75).epsilon(0.01));
    CHECK_THROWS_WITH_AS(line(mask, {0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0}),
                         "the figure has a point whose coordinates are beyond the range of numbers",
                         Error);
}

TEST_CASE("taken in rectangles or as a whole, the coverage is that of cell after cell") {
    CHECK(rc::check("random lines", [] {
        const int cells = *rc::gen::element(2, 4, 8);
        const int diameter = *rc::gen::inRange(1, 12);
        const int width = 24, height = 18;
        Mask mask(width, height, cells, diameter);
        std::vector<Point> marks;  // single cells: lines from a point to itself
        for (int i = *rc::gen::inRange(1, 6); i > 0; --i)
            marks.push_back({*rc::gen::inRange(0, width * cells - 1) + 0.25,
                             *rc::gen::inRange(0, height * cells - 1) + 0.25});
        for (const Point& mark : marks) line(mask, mark, mark);
        const Mask::Coverage covered = mask.take();

        // Each cell on its own: is its middle within the disc of a mark? Discs stand around cells'
        // middles or corners, whichever suits their rows; borders may differ by the rounding of
        // a row's ends, so cells well inside and well outside are compared.
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                int least = 0, most = 0;
                for (int j = 0; j < cells * cells; ++j) {
                    const double u = x * cells + j % cells + 0.5, v = y * cells + j / cells + 0.5;
                    double nearest = 1e9;
                    for (const Point& mark : marks) {
                        const double about = diameter % 2 == 0 ? 0 : 0.5;
                        const double a = std::floor(mark.x + 0.5 - about) + about;
                        const double b = std::floor(mark.y + 0.5 - about) + about;
                        nearest = std::min(nearest, std::hypot(u - a, v - b));
                    }
                    least += nearest <= diameter / 2.0 - 0.75;
                    most += nearest <= diameter / 2.0 + 0.75;
                }
                int value = 0;
                if (x >= covered.left && x < covered.left + covered.width && y >= covered.top &&
                    y < covered.top + covered.height)
                    value =
                        covered.values[static_cast<std::size_t>(y - covered.top) * covered.stride +
                                       static_cast<std::size_t>(x - covered.left)];
                const double count = value * cells * cells / 255.0;
                RC_ASSERT(count > least - 0.6);
                RC_ASSERT(count < most + 0.6);
            }
    }));
}

TEST_CASE("drawn in cells, the dragon looks as Cairo draws it") {
    const DrawnFigure figure = dragon(16);
    const Endless endless(figure);
    using Route = PictureOptions::Route;
    for (const int width : {64, 128, 200, 400})
        for (const double line_width : {0.5, 1.0, 2.0}) {
            CAPTURE(width);
            CAPTURE(line_width);
            const Pixels cells = drawn(figure, width, line_width, Route::cells);
            const Pixels chords = drawn(endless, width, line_width, Route::cells);
            const Pixels strokes = drawn(figure, width, line_width, Route::strokes);
            const Pixels at_once = brute_force(figure, cells, line_width);
            CHECK(difference(cells, strokes) < 2);
            CHECK(difference(chords, strokes) < 2);
            CHECK(difference(cells, at_once) < 2);
            CHECK(difference(chords, at_once) < 2);
        }
}

TEST_CASE("chords instead of parts below a third of a pixel do not show") {
    const Endless figure(dragon(19));
    using Route = PictureOptions::Route;
    const Pixels chords = drawn(figure, 100, 1, Route::cells);
    CHECK(difference(chords, brute_force(figure, chords, 1)) < 2);
}
