#include "render/render.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <sstream>

#include "exact/exact.hpp"
#include "render/detail/drawing.hpp"
#include "render/figures.hpp"
#include "render/pixels.hpp"

using namespace algae;
using namespace algae::test;

namespace {

/// The same calls, drawn in layers.
class Layered : public DrawnFigure {
public:
    using DrawnFigure::DrawnFigure;
    bool is_layered() const override { return true; }
};

Pixels picture_of(const Figure& figure) {
    std::ostringstream png;
    PictureOptions options;
    options.width = 120;
    options.height = 100;
    draw_picture({&figure, "a figure", ""}, png, PictureFormat::png, options, {});
    return Pixels(png.str());
}

}  // namespace

TEST_CASE("layers are what Cairo draws") {
    CHECK(rc::check([] {
        struct Part {
            std::vector<Point> corners;
            bool stroke;
            Colour colour;
        };
        std::vector<Part> parts(static_cast<std::size_t>(*rc::gen::inRange(1, 8)));
        const auto number = [] { return *rc::gen::inRange(0, 1000) / 100.0; };
        for (Part& part : parts) {
            part.stroke = *rc::gen::arbitrary<bool>();
            part.colour = {number() / 10, number() / 10, number() / 10};
            const int count = part.stroke ? 2 : 3;
            for (int i = 0; i < count; ++i) part.corners.push_back({number(), number()});
        }
        const auto calls = [parts](Canvas& canvas, double) {
            canvas.width(3);
            for (const Part& part : parts) {
                canvas.paint(part.colour);
                if (part.stroke) {
                    canvas.move_to(part.corners[0]);
                    canvas.line_to(part.corners[1]);
                } else {
                    canvas.polygon(part.corners);
                }
            }
        };
        const DrawnFigure plain(calls);
        const Layered layered(calls);
        if (plain.box().breadth() == 0 || plain.box().height() == 0) return;
        RC_ASSERT(difference(picture_of(plain), picture_of(layered)) < 0.5);
    }));
}

TEST_CASE("lengths of scale bars are round and fit") {
    CHECK(rc::check([] {
        const double breadth = std::pow(10.0, *rc::gen::inRange(-9000, 9000) / 1000.0);
        const double length = scale_bar_length(breadth);
        RC_ASSERT(length <= breadth / 4 * (1 + 1e-9));
        RC_ASSERT(length >= breadth / 10 * (1 - 1e-9));
    }));
    CHECK(scale_bar_length(100) == 20);
    CHECK(scale_bar_length(8) == 2);
    CHECK(scale_bar_length(0.5) == 0.1);
}
