#pragma once
// The turtle for words of modules: what a file says its symbols mean, the turtle that does it, what
// hears of it, and the walk over a word.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "turtle/turtle.hpp"

namespace algae {

struct SolidSetting;
struct SurfaceSetting;
enum class StampShape : unsigned char;

/// What modules of a symbol mean that a file declares with `solid`.
class SolidModule {
public:
    /// The kind must be one of solid_kinds(), the measures some of its own.
    explicit SolidModule(const SolidSetting& setting);

    /// The solid's shape; none if the module turns or moves the turtle.
    std::optional<SolidShape> shape() const;
    /// Whether it turns the turtle, by degrees about its heading, left and up in this order.
    bool is_rotation() const { return kind_ == rotation; }

    /// The measures that so many parameters give, as Solid has them, in steps: of a box along
    /// heading, left and up, of a cylinder and a cone height and radius, of a sphere the radius; of a
    /// rotation and a translation x, y and z. Solids are 1 where nothing is said, the others 0.
    Vector size(const double* values, std::uint32_t count) const;
    /// The parameter that is the number of the colour, if there is one.
    std::optional<double> colour(const double* values, std::uint32_t count) const;

private:
    enum Kind : std::uint8_t { box, cylinder, cone, sphere, rotation, translation };
    static constexpr std::uint32_t absent = UINT32_MAX;

    std::optional<double> measure(std::size_t number, const double* values,
                                  std::uint32_t count) const;

    Kind kind_ = box;
    std::array<std::uint32_t, 4> parameters_{};  // by measure of the kind: the parameter's number
};

/// The flat polygons of a surface, their points along heading, left and up of the turtle, in steps.
///
/// - A leaf begins where the turtle stands, points along the heading, is 1 long and 2/5 wide.
/// - A petal begins there too, is 1 long and 3/5 wide, widest near its round end.
/// - A disc has its middle there and the diameter 1.
/// - A polygon is itself. A patch is a bicubic Bezier surface over four rows of four points (Foley and
///   others 1990, 11.3), as 72 triangles.
///
/// Example: surface_faces({0, "disc", {}}).front().front() == Vector{0.5, 0, 0}
std::vector<std::vector<Vector>> surface_faces(const SurfaceSetting& surface);

/// Whether all of it lies in the plane of heading and left.
bool is_flat(const SurfaceSetting& surface);

/// What a turtle can be told to do. The operations of words without parameters come first, in the order
/// of Command.
enum class TurtleOperation : std::uint8_t {
    draw,
    draw_unmarked,
    move,
    left,
    right,
    back,
    push,
    pop,
    open_polygon,
    close_polygon,
    vertex,
    scale,
    width,
    colour,
    cut,  // the last of Command
    nothing,
    down,
    up,
    roll_left,
    roll_right,
    level,
    plot,
    stamp,
    solid,
    surface,
    elasticity
};

/// What a symbol means by its name, where the file does not declare it, with so many parameters.
TurtleOperation named_operation(const std::string& name, const Drawing& drawing,
                                std::uint32_t parameters);

/// Whether the name alone makes a figure one in space: & ^ \ / and $.
bool turns_out_of_plane(const std::string& name);

/// What the modules of a letter with so many parameters tell the turtle. The table is at
/// ModuleTurtle.
struct TurtleCommand {
    TurtleOperation operation = TurtleOperation::nothing;
    std::uint32_t parameters = 0;
    StampShape shape{};                      // of a stamp
    std::optional<SolidModule> solid;        // of a solid
    std::vector<std::vector<Vector>> faces;  // of a surface
    bool leaves_plane = false;               // the figure is one in space where this is done

    /// How many of the parameters it looks at.
    std::uint32_t read() const;
};

/// The command of a letter with this number of parameters, in a system over this alphabet.
TurtleCommand turtle_command(const Alphabet& alphabet, const Drawing& drawing, Symbol letter,
                             std::uint32_t parameters);

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

/// How a system wants its turtle to be: where it starts in a generation, and what commands without
/// parameters mean.
struct TurtleManner {
    TurtleState start;
    double angle = 90;       // degrees, negative where + turns right
    bool clockwise = false;  // + turns right
    double scale = 1, narrow = 1;
    std::optional<Vector> tropism;
    bool bends_before = false;  // before steps and moves, not after strokes
};

/// The length of a step in a generation; `name` is what messages call it. Throws Error if it is 0 or not
/// a number.
double step_length(const Drawing& drawing, std::uint64_t generation, const std::string& name);

/// The manner of a system in a generation; `name` is what messages call it. Throws Error if the step is
/// 0 or no number, or the heading no number.
TurtleManner turtle_manner(const Model& system, std::uint64_t generation, const std::string& name);

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
/// Lindenmayer 1990, 2.3.4). T is not made a unit vector. `tropism ... before` turns it by that angle,
/// or one radian if that is less, before each F, G and f (cpfg 4.0). A symbol of `elasticity` makes the
/// susceptibility that number, or, with two, the first times what it was and the second.
///
/// `interpret` rules are applied to each module, and to what they give, until none matches. Where
/// they have probabilities, the numbers are those of Draws for the seed with all bits turned round,
/// one for each choice on the way; so every walk over a word is the same.
class ModuleTurtle {
public:
    /// For words over these kinds. Throws Error if an interpretation rule has contexts, `Diagnostics` if
    /// constant expression has no value, and Error if the step is 0 or no number.
    ModuleTurtle(const Model& system, const ModuleKinds& kinds, std::uint64_t generation,
                 std::uint64_t seed = 1);

    /// Walks the word and says where it ends. Linear in the number of commands.
    ///
    /// Throws Error, with the generation, the module and its position, for brackets or braces that
    /// do not match, an amount that makes no sense, a position that is not finite, a heading that
    /// is vertical where it is to be levelled, and interpretations that never end; what
    /// budget.check throws.
    TurtleState walk(const ModuleString& word, TurtleEvents& events,
                     const Budget& budget = {}) const;

    /// The modules that the turtle obeys on its walk over the word, in place of those that are interpreted, with kinds of `kinds()`.
    /// `lengths` becomes how many each module of the word gives. Throws what `walk` throws of interpretations.
    ModuleString interpreted(const ModuleString& word, std::vector<std::uint32_t>& lengths,
                             const Budget& budget = {}) const;
    /// The kinds of the modules that it obeys, and what they tell it.
    const ModuleKinds& kinds() const { return rules_.kinds; }
    const TurtleCommand& command(ModuleKind kind) const { return commands_[kind]; }
    const TurtleManner& manner() const { return manner_; }

    /// The symbol by which the word, or an interpretation that it may use, leaves the plane: & ^ \ / $,
    /// a solid, a surface that is not flat or a plot of three coordinates. Nothing for a figure in the plane.
    std::optional<Symbol> symbol_of_space(const ModuleString& word) const;

    /// The turtle before the first module.
    const TurtleState& start() const { return manner_.start; }
    /// The figure_name.
    const std::string& name() const { return name_; }

private:
    class Walk;

    bool has_interpretation(ModuleKind kind) const;

    CompiledRules rules_;                  // the interpretation; its own numbers for kinds
    std::vector<ModuleKind> own_kinds_;    // by kind of the word
    std::vector<TurtleCommand> commands_;  // by own kind; where no interpretation matches
    std::vector<char> interpreted_;        // by own kind: some interpretation may match
    std::string name_;
    TurtleManner manner_;
    std::uint64_t generation_, seed_;
};

/// A turtle's glyph: an arrowhead around the place, ahead of it and behind by half of `size`: its
/// tip, left corner, notch and right corner.
///
/// Example: turtle_glyph({}, 2).front() == Vector{1, 0, 0}
std::vector<Vector> turtle_glyph(const TurtleState& turtle, double size);

}  // namespace algae
