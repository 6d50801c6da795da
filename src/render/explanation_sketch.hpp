#pragma once

#include <string>
#include <vector>

#include "render/palette.hpp"
#include "turtle/canvas.hpp"
#include "turtle/explanation.hpp"

typedef struct _cairo cairo_t;

namespace algae {

/// The drawing of an explanation: strokes, the turtle at every corner, and the numbers of steps.
class ExplanationSketch {
public:
    ExplanationSketch(const Explanation& explanation, const Palette& palette);

    /// The ways from left to right and from top to bottom, 0 or more.
    double breadth() const { return box_.breadth(); }
    double height() const { return box_.height(); }
    /// The length that every step should have room for: of the shortest that moves; 0 if none does.
    double shortest() const { return shortest_; }
    /// Whether the turtle turns somewhere, and whether it moves with its pen up.
    bool turns() const;
    bool has_moves() const;

    /// Draws it in the middle of this rectangle, at most `largest` units of the picture to one of
    /// the figure. Labels stay within the rectangle.
    void draw(cairo_t* context, double left, double top, double width, double height,
              double largest) const;

    /// The room that labels and turtles need around the lines.
    static constexpr double room = 34;

private:
    /// Steps that happen in one place, one after the other.
    struct Stand {
        std::size_t first, last;
        Vector position;
        Attitude before, after;
        bool turns = false;
    };

    void find_stands();

    const Explanation& explanation_;
    const Palette& palette_;
    Box box_;
    double shortest_ = 0;
    std::vector<Stand> stands_;
};

}  // namespace algae
