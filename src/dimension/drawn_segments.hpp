#pragma once

#include <span>
#include <utility>

#include "turtle/canvas.hpp"

namespace algae {

/// A canvas that gives every segment drawn to a function `use(from, to, joined)`, those of the
/// outlines of polygons too; `joined` where it goes on from the end of the one before.
template <class Use>
class DrawnSegments final : public Canvas {
public:
    explicit DrawnSegments(Use use) : use_(std::move(use)) {}

    void move_to(Point point) override {
        here_ = point;
        joined_ = false;
    }
    void line_to(Point point) override {
        use_(here_, point, joined_);
        here_ = point;
        joined_ = true;
    }
    void polygon(std::span<const Point> corners) override {
        if (corners.empty()) return;
        move_to(corners.back());
        for (const Point corner : corners) line_to(corner);
        joined_ = false;
    }
    void width(double) override {}
    void width_as_length(double) override {}
    void colour(std::uint32_t) override {}
    void position(double) override {}

private:
    Use use_;
    Point here_;
    bool joined_ = false;
};

}  // namespace algae
