#include "space/scene_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace algae {

namespace {

constexpr Colour grey{0.62, 0.62, 0.6}, black{0, 0, 0};

}  // namespace

Colour LitScene::colour(const Paint& paint, bool line) const {
    if (paint.colour) return *paint.colour;
    if (default_colours) return line ? black : grey;
    return colours[paint.index % colours.size()];
}

double LitScene::end_radius(std::uint32_t rod) const {
    const std::uint32_t after = next[rod];
    const double own = scene.rods[rod].radius;
    return after == Rod::none || scene.rods[after].radius == 0
               ? own
               : std::min(own, scene.rods[after].radius);
}

ScenePainter::ScenePainter(Canvas& canvas, const LitScene& lit)
    : canvas_(canvas), lit_(lit), painted_(lit.scene.rods.size(), 0) {}

void ScenePainter::paint(const SeenThing& thing) {
    std::visit([this](const auto& kind) { paint_thing(kind); }, thing);
}

void ScenePainter::multiple_width(double factor) {
    if (!width_is_length_ && width_ == factor) return;
    canvas_.width(factor);
    width_ = factor;
    width_is_length_ = false;
}

void ScenePainter::length_width(double length) {
    if (width_is_length_ && width_ == length) return;
    canvas_.width_as_length(length);
    width_ = length;
    width_is_length_ = true;
}

void ScenePainter::polygon(const Colour& colour, std::span<const Point> corners) {
    canvas_.paint(colour);
    canvas_.polygon(corners);
}

void ScenePainter::paint_thing(const SeenStick& stick) {
    if (lit_.scene.rods[stick.rod].radius > 0)
        paint_tube(stick);
    else
        paint_line(stick);
}

void ScenePainter::paint_line(const SeenStick& stick) {
    const Rod& rod = lit_.scene.rods[stick.rod];
    const double half = (std::fabs(rod.line_width) / 2 + lit_.gap) * lit_.line_width;
    const double dx = stick.to.x - stick.from.x, dy = stick.to.y - stick.from.y,
                 way = std::hypot(dx, dy);
    const std::uint32_t before = rod.before, after = lit_.next[stick.rod];
    const bool has_gap = lit_.gap > 0 && half > 0;
    if (has_gap && way > 0) {
        const double x = dx / way, y = dy / way;
        const double a = stick.begins == 0 && before != Rod::none ? half : 0;
        const double b = stick.ends == 1 && after != Rod::none ? half : 0;
        if (way > a + b) {
            const Point from{stick.from.x + a * x, stick.from.y + a * y},
                to{stick.to.x - b * x, stick.to.y - b * y};
            polygon(lit_.background, std::array{Point{from.x - half * y, from.y + half * x},
                                                Point{from.x + half * y, from.y - half * x},
                                                Point{to.x + half * y, to.y - half * x},
                                                Point{to.x - half * y, to.y + half * x}});
        }
    }
    canvas_.paint(lit_.lighting.at_depth(lit_.colour(rod.paint, true),
                                         (stick.from.depth + stick.to.depth) / 2));
    multiple_width(rod.line_width);
    canvas_.move_to(flat(stick.from));
    canvas_.line_to(flat(stick.to));
    if (!has_gap) return;
    painted_[stick.rod] = 1;
    // What the gap may have taken from the ends of the lines that this one joins.
    if (stick.begins == 0 && before != Rod::none && painted_[before])
        paint_stub(before, false, 2 * half);
    if (stick.ends == 1 && after != Rod::none && painted_[after]) paint_stub(after, true, 2 * half);
}

void ScenePainter::paint_stub(std::uint32_t index, bool at_start, double reach) {
    const Rod& rod = lit_.scene.rods[index];
    if (rod.radius > 0) return;
    const Seen from = lit_.projection(at_start ? rod.from : rod.to),
               to = lit_.projection(at_start ? rod.to : rod.from);
    const double way = std::hypot(to.x - from.x, to.y - from.y);
    const double share = way > reach ? reach / way : 1;
    canvas_.paint(
        lit_.lighting.at_depth(lit_.colour(rod.paint, true), (from.depth + to.depth) / 2));
    multiple_width(rod.line_width);
    canvas_.move_to(flat(from));
    canvas_.line_to({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
}

}  // namespace algae
