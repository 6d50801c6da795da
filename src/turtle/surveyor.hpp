#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "turtle/canvas.hpp"

namespace algae {

/// A canvas that measures what is drawn on it.
class Surveyor : public Canvas {
public:
    void move_to(Point point) override { from_ = point; }
    void line_to(Point point) override {
        ++lines;
        box.add(from_);
        box.add(point);
        widest_length = std::max(widest_length, length_);
        const double x = point.x - from_.x, y = point.y - from_.y;
        const double square = x * x + y * y;
        if (square > 0 && square < shortest_square_) shortest_square_ = square;
        from_ = point;
    }
    void polygon(std::span<const Point> corners) override {
        ++polygons;
        for (const Point corner : corners) box.add(corner);
    }
    void width(double) override { length_ = 0; }
    void width_as_length(double length) override { length_ = length; }
    void colour(std::uint32_t) override {}
    void position(double) override {}

    /// The length of the shortest stroke that has one; infinite if none has.
    double shortest() const { return std::sqrt(shortest_square_); }

    Box box;
    std::uint64_t lines = 0, polygons = 0;
    double widest_length = 0;  // of the strokes whose width is a length

private:
    Point from_;
    double length_ = 0;
    double shortest_square_ = std::numeric_limits<double>::infinity();
};

}  // namespace algae
