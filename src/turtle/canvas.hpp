#pragma once

#include <cstdint>
#include <span>

#include "system/settings.hpp"

namespace algae {

/// A point of the plane in the units of the file: x to the right, y upward.
struct Point {
    double x = 0, y = 0;
    bool operator==(const Point&) const = default;
};

/// The smallest box with sides parallel to the axes around something; `empty` when there is nothing.
struct Box {
    Point low, high;
    bool empty = true;

    void add(Point point) {
        if (empty) {
            low = high = point;
            empty = false;
            return;
        }
        if (point.x < low.x) low.x = point.x;
        if (point.y < low.y) low.y = point.y;
        if (point.x > high.x) high.x = point.x;
        if (point.y > high.y) high.y = point.y;
    }
    void add(const Box& box) {
        if (box.empty) return;
        add(box.low);
        add(box.high);
    }
    double breadth() const { return empty ? 0 : high.x - low.x; }
    double height() const { return empty ? 0 : high.y - low.y; }
    bool operator==(const Box&) const = default;
};

/// What a figure is drawn on. A figure calls these in drawing order; a canvas knows picture
/// formats, scales and strokes, a figure knows none of them.
class Canvas {
public:
    virtual ~Canvas() = default;

    /// Lifts the pen and sets it down at `point`. Called before the first `line_to` and wherever
    /// a stroke does not go on from the end of the last one.
    virtual void move_to(Point point) = 0;
    /// A straight stroke from where the pen is.
    virtual void line_to(Point point) = 0;
    /// A filled polygon with these corners; lifts the pen.
    virtual void polygon(std::span<const Point> corners) = 0;

    /// The line width from here on, as a multiple of the figure's own line width.
    virtual void width(double factor) = 0;
    /// The same as a length in the units of the file.
    virtual void width_as_length(double length) = 0;
    /// The index of the colour in the figure's list, from here on.
    virtual void colour(std::uint32_t index) = 0;
    /// A colour that is in no list, from here on.
    virtual void paint(const Colour& /*colour*/) {}
    /// How far along the word the figure is, from 0 to 1: for a hue that runs with it, and for
    /// progress. Called before each stroke or polygon if `wants_position()`.
    virtual void position(double fraction) = 0;
    virtual bool wants_position() const { return false; }
    /// The figure's own line width in the units of the file; 0 if the canvas has none.
    virtual double line_width() const { return 0; }
};

}  // namespace algae
