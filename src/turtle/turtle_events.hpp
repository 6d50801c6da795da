#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "system/settings.hpp"
#include "turtle/pose.hpp"
#include "turtle/solid_shape.hpp"

namespace algae {

/// How wide a turtle's strokes are: a multiple of the figure's line width, or, after `!(w)`, a
/// length in the units of the figure.
struct StrokeWidth {
    double amount = 1;
    bool is_length = false;
    bool operator==(const StrokeWidth&) const = default;
};

/// All that a turtle knows of itself.
struct TurtleState {
    Vector position;
    Attitude attitude;
    double step = 1;  // length of a step, in the units of the figure
    StrokeWidth width;
    std::uint32_t colour = 0;     // in the list of the file
    std::optional<Colour> paint;  // instead of it, after '(r,g,b)
};

/// What hears of a turtle's walk, in the order of the word. All points are in the units of the file.
class TurtleEvents {
public:
    virtual ~TurtleEvents() = default;

    /// Before each module of the word: its position, counted from 0, and the turtle as it gets there.
    /// What interpretation makes of a module belongs to it. Called only if `wants_modules()`.
    virtual void before(std::size_t /*module*/, const TurtleState&) {}
    virtual bool wants_modules() const { return false; }

    /// A straight stroke from a point to where the turtle now is.
    virtual void stroke(const Vector& /*from*/, const TurtleState&) {}
    /// The same with the pen up.
    virtual void move(const Vector& /*from*/, const TurtleState&) {}
    /// A branch begins; it ends when the turtle returns.
    virtual void branched(const TurtleState&) {}
    /// The turtle is back at the beginning of a branch.
    virtual void returned(const TurtleState&) {}
    /// A filled polygon, its corners in order.
    virtual void polygon(std::span<const Vector> /*corners*/) {}
    /// A filled shape of this size centred at the turtle, turned as it looks. Sends the polygon of
    /// `stamp_corners` unless somebody knows better.
    virtual void stamp(StampShape shape, double size, const TurtleState& state);
    /// A solid around the turtle, turned as it looks: of a box `size` is along heading, left and up;
    /// a cylinder and a cone have the height size.x and the radius size.y, a sphere the radius size.x.
    virtual void solid(SolidShape, const Vector& /*size*/, const TurtleState&) {}
    /// The width from here on, and the colour: one of the list, or one of its own.
    virtual void width(const StrokeWidth&) {}
    virtual void colour(std::uint32_t /*index*/) {}
    virtual void paint(const Colour&) {}
};

/// The corners of a stamp in the plane of heading and left: a square of this side, its sides along
/// them; a circle of this diameter, as 64 corners; an equilateral triangle of this side, one corner
/// ahead.
///
/// Example: stamp_corners(StampShape::square, 2, {}).front() == Vector{1, 1, 0}
std::vector<Vector> stamp_corners(StampShape shape, double size, const TurtleState& state);

}  // namespace algae
