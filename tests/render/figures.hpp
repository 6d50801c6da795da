#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "turtle/turtle.hpp"

namespace algae::test {

/// A figure made of calls on a canvas: what the tests of pictures draw. It shares nothing with the
/// room that makes figures of systems.
class DrawnFigure : public Figure {
public:
    explicit DrawnFigure(std::function<void(Canvas&, double)> calls) : calls_(std::move(calls)) {
        Measure measure;
        calls_(measure, 0);
        box_ = measure.box;
        facts_.segments = Integer(measure.lines);
        facts_.widest = measure.widest;
        if (measure.lines > 0) facts_.step = measure.way / static_cast<double>(measure.lines);
        strokes_ = measure.lines;
    }

    const Box& box() const override { return box_; }
    const Integer& segments() const override { return facts_.segments; }
    const Facts& facts() const override { return facts_; }
    std::optional<std::uint64_t> strokes() const override { return strokes_; }
    const FigureStyle& style() const override { return own; }
    void draw(Canvas& canvas, double resolution, const Budget&) const override {
        calls_(canvas, resolution);
    }

    FigureStyle own;

private:
    struct Measure : Canvas {
        void move_to(Point point) override { here = point; }
        void line_to(Point point) override {
            box.add(here);
            box.add(point);
            way += std::hypot(point.x - here.x, point.y - here.y);
            here = point;
            ++lines;
        }
        void polygon(std::span<const Point> corners) override {
            for (const Point& corner : corners) box.add(corner);
            ++lines;
        }
        void width(double) override {}
        void width_as_length(double length) override { widest = std::fmax(widest, length); }
        void colour(std::uint32_t) override {}
        void position(double) override {}
        double widest = 0, way = 0;
        Box box;
        Point here;
        std::uint64_t lines = 0;
    };

    std::function<void(Canvas&, double)> calls_;
    Box box_;
    Facts facts_;
    std::uint64_t strokes_ = 0;
};

/// Lines through these points.
inline DrawnFigure polyline(std::vector<Point> points) {
    return DrawnFigure([points = std::move(points)](Canvas& canvas, double) {
        if (points.empty()) return;
        canvas.move_to(points.front());
        for (std::size_t i = 1; i < points.size(); ++i) canvas.line_to(points[i]);
    });
}

/// Koch's curve from (0, 0) to (1, 0), by recursion over its corners.
inline DrawnFigure koch(int generation) {
    return DrawnFigure([generation](Canvas& canvas, double) {
        const auto piece = [&canvas](const auto& again, Point from, Point to, int n) -> void {
            if (n == 0) return canvas.line_to(to);
            const double dx = (to.x - from.x) / 3, dy = (to.y - from.y) / 3;
            const double h = std::numbers::sqrt3 / 2;
            const Point a{from.x + dx, from.y + dy}, c{to.x - dx, to.y - dy};
            const Point b{a.x + dx / 2 - dy * h, a.y + dy / 2 + dx * h};
            again(again, from, a, n - 1);
            again(again, a, b, n - 1);
            again(again, b, c, n - 1);
            again(again, c, to, n - 1);
        };
        canvas.move_to({0, 0});
        piece(piece, {0, 0}, {1, 0}, generation);
    });
}

/// The dragon curve from (0, 0) to (1, 0): each line becomes the two sides of a right angle, in
/// turn to its left and its right. A part that lies within the resolution becomes a line: the
/// curve over a line stays within 1.2 of its length.
inline void draw_dragon(Canvas& canvas, int generation, double resolution) {
    const double tell_every = canvas.wants_position() ? 1 : 0;
    const auto piece = [&](const auto& again, Point from, Point to, int n, int side, double at,
                           double share) -> void {
        const double dx = to.x - from.x, dy = to.y - from.y;
        if (n == 0 || 1.2 * std::hypot(dx, dy) < resolution) {
            if (tell_every > 0) canvas.position(at);
            return canvas.line_to(to);
        }
        const Point corner{from.x + (dx - side * dy) / 2, from.y + (dy + side * dx) / 2};
        again(again, from, corner, n - 1, 1, at, share / 2);
        again(again, corner, to, n - 1, -1, at + share / 2, share / 2);
    };
    canvas.move_to({0, 0});
    piece(piece, {0, 0}, {1, 0}, generation, 1, 0, 1);
}

inline DrawnFigure dragon(int generation) {
    return DrawnFigure([generation](Canvas& canvas, double resolution) {
        draw_dragon(canvas, generation, resolution);
    });
}

}  // namespace algae::test
