#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "rewrite/module_string.hpp"
#include "rewrite/rule_set.hpp"
#include "system/lsystem.hpp"
#include "turtle/pose.hpp"
#include "turtle/solid_module.hpp"

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

/// "generation 5 of koch", as messages call it.
std::string figure_name(const LSystem& system, std::uint64_t generation);

/// A turtle for words of modules, in the plane and in space (Prusinkiewicz and Lindenmayer 1990,
/// 1.5 and 1.10.3; Hanan 1992). Positions are doubles.
///
/// It starts at the file's `start` with H along +x, L along +y and U along +z, turned about U by the
/// heading of the start and `spin` times the generation. The first parameter of a module says how
/// much; without one it is the step or the angle of the file. Further ones are not looked at.
///
/// - F, F_x, G draw and f, f_x move that many steps; the step is `step` times `shrink` to the power
///   of the generation. Negative amounts go backward.
/// - + and - turn left and right, & and ^ pitch down and up, \ and / roll left and right, by degrees;
///   | turns back; $ and @ roll until L is level.
/// - `*` multiplies the turtle's own step by `scale`, `*(k)` by k. `!` multiplies the width by `narrow`,
///   `!(w)` sets it to the length w. ' goes on to the next colour, '(k) to colour k,
///   '(r,g,b) to the colour with these parts, each from 0 to 1.
/// - [ ] { } . and % are those of the plane.
/// - A symbol of `plot` with two or three parameters draws a line to that point and stands there.
/// - A symbol of `stamp` leaves its shape, of the size of two steps, or of as many as it says.
/// - A symbol of `solid` leaves its solid, or turns or moves the turtle with the pen up; its parameters
///   are measures in steps and degrees (see SolidModule). A rotation is counter-clockwise, first
///   about the heading, then about the left and then about the up that come of it.
/// - A symbol of `surface` leaves it, once or as many times as large as it says; see surface_faces.
///
/// Where the file has a `tropism` T, the turtle is turned after each stroke by the angle e |H x T| in
/// radians about H x T, so that H goes towards T, e being the `susceptibility` (Prusinkiewicz and
/// Lindenmayer 1990, 2.3.4). T is not made a unit vector.
///
/// `interpret` rules are applied to each module, and to what they give, until none matches. Where
/// they have probabilities, the numbers are those of Draws for the seed with all bits turned round,
/// one for each choice on the way; so every walk over a word is the same.
class ModuleTurtle {
public:
    /// For words over these kinds. Throws Error if an interpretation rule has contexts, `Diagnostics` if
    /// constant expression has no value, and Error if the step is 0 or no number.
    ModuleTurtle(const LSystem& system, const ModuleKinds& kinds, std::uint64_t generation,
                 std::uint64_t seed = 1);

    /// Walks the word and says where it ends. Linear in the number of commands.
    ///
    /// Throws Error, with the generation, the module and its position, for brackets or braces that
    /// do not match, an amount that makes no sense, a position that is not finite, a heading that
    /// is vertical where it is to be levelled, and interpretations that never end; what
    /// budget.check throws.
    TurtleState walk(const ModuleString& word, TurtleEvents& events,
                     const Budget& budget = {}) const;

    /// The symbol by which the word, or an interpretation that it may use, leaves the plane: & ^ \ / $,
    /// a solid, a surface that is not flat or a plot of three coordinates. Nothing for a figure in the plane.
    std::optional<Symbol> symbol_of_space(const ModuleString& word) const;

    /// The turtle before the first module.
    const TurtleState& start() const { return start_; }
    /// The figure_name.
    const std::string& name() const { return name_; }

private:
    class Walk;

    enum class Operation : std::uint8_t {
        nothing,
        draw,
        draw_unmarked,
        move,
        left,
        right,
        down,
        up,
        roll_left,
        roll_right,
        back,
        level,
        push,
        pop,
        open_polygon,
        close_polygon,
        vertex,
        scale,
        width,
        colour,
        cut,
        plot,
        stamp,
        solid,
        surface
    };

    Operation operation_of(ModuleKind kind) const;
    bool has_interpretation(ModuleKind kind) const;

    CompiledRules rules_;                // the interpretation; its own numbers for kinds
    std::vector<ModuleKind> own_kinds_;  // by kind of the word
    std::vector<Operation> operations_;  // by own kind; where no interpretation matches
    std::vector<char> interpreted_;      // by own kind: some interpretation may match
    std::map<Symbol, SolidModule> solids_;
    std::map<Symbol, std::vector<std::vector<Vector>>> surfaces_;  // their faces
    std::optional<Vector> tropism_;
    double susceptibility_ = 1;
    std::string name_;
    TurtleState start_;
    double angle_ = 90;
    double scale_ = 1, narrow_ = 1;
    std::uint64_t generation_, seed_;
};

}  // namespace algae
