#pragma once
// turtle: words to figures in the plane and in space. A turtle walks over the word of a generation
// and draws: in the plane a Figure that can be sent to any Canvas, in space a Scene of rods, solids
// and polygons that a camera sees or a mesh stands for. Figures of systems without parameters are
// exact wherever their angles and steps allow it; the others are walked in doubles. Open L-systems
// ask their environment on the way. The room knows no picture format and no mesh format.

#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "rewrite/rewrite.hpp"
#include "system/system.hpp"
#include "turtle/detail/lattice_motions.hpp"

namespace algae {

struct Drawing;
struct Model;

// -------------------------------------------------------------------------------------------------
// Places and directions

/// A point of space or a way in it: x and y are those of the plane, z upward out of it.
struct Vector {
    double x = 0, y = 0, z = 0;

    bool operator==(const Vector&) const = default;
    friend Vector operator+(const Vector& a, const Vector& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend Vector operator-(const Vector& a, const Vector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend Vector operator*(double factor, const Vector& a) {
        return {factor * a.x, factor * a.y, factor * a.z};
    }
};

/// The inner product.
///
/// Example: dot(Vector{1, 2, 3}, Vector{4, 5, 6}) == 32
inline double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The vector product.
///
/// Example: cross(Vector{1, 0, 0}, Vector{0, 1, 0}) == Vector{0, 0, 1}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }

/// The vector of length 1 that way; nothing stays nothing.
///
/// Example: unit(Vector{0, 3, 0}) == Vector{0, 1, 0}
inline Vector unit(const Vector& way) {
    const double size = length(way);
    return size > 0 ? (1 / size) * way : way;
}

/// What a turn by some angle needs.
struct Turn {
    double cosine = 1, sine = 0;
};

/// The turn by so many degrees. Multiples of 90 degrees are exact, of 30 and 45 as exact as doubles
/// allow, and opposite turns are exactly opposite. The angle must be finite.
///
/// Example: turn_by(-270).sine == 1
Turn turn_by(double degrees);

/// The way a turtle looks in space: heading, left and up, unit vectors with heading x left = up.
///
/// Turns are those of Abelson and diSessa (1982) as Prusinkiewicz and Lindenmayer (1990, 1.5) write
/// them, [H' L' U'] = [H L U] R, with the signs by which the commands do what they are called: a
/// positive `yaw` goes to the left, `pitch` down, `roll` to the left. Turns by multiples of 90
/// degrees are exact; the rounding of others is taken out every few turns, so that the vectors
/// stay orthonormal to 1e-14 however many there are.
class Attitude {
public:
    const Vector& heading() const { return heading_; }
    const Vector& left() const { return left_; }
    const Vector& up() const { return up_; }

    /// About up: + is a positive turn, the heading goes towards left.
    void yaw(const Turn& turn) { rotate(heading_, left_, turn); }
    /// About left: & is a positive turn, the heading goes away from up.
    void pitch(const Turn& turn) { rotate(heading_, up_, {turn.cosine, -turn.sine}); }
    /// About the heading: \ is a positive turn, left goes away from up.
    void roll(const Turn& turn) { rotate(left_, up_, {turn.cosine, -turn.sine}); }
    /// About up by 180 degrees.
    void turn_back() {
        heading_ = -1.0 * heading_;
        left_ = -1.0 * left_;
    }
    /// Turns by an angle in radians about the axis heading x `to`, so that the heading goes towards `to`;
    /// nothing if they are parallel.
    void bend(const Vector& to, double radians);
    /// Rolls until left is level and up does not look down: L' = V x H / |V x H| with V = (0,0,1).
    /// False, and nothing done, if the heading is vertical, so that every left is level.
    bool level();

private:
    /// Turns two of the vectors in their plane, `first` towards `second`.
    void rotate(Vector& first, Vector& second, const Turn& turn) {
        const Vector before = first;
        first = turn.cosine * first + turn.sine * second;
        second = turn.cosine * second - turn.sine * before;
        if (++turns_ % 16 == 0) straighten();
    }
    /// Makes the vectors orthonormal again (Gram and Schmidt); exactly orthonormal ones stay.
    void straighten() {
        heading_ = unit(heading_);
        left_ = left_ - dot(heading_, left_) * heading_;
        left_ = unit(left_);
        up_ = cross(heading_, left_);
    }

    Vector heading_{1, 0, 0}, left_{0, 1, 0}, up_{0, 0, 1};
    std::uint32_t turns_ = 0;
};

/// A point of the plane in the units of the file: x to the right, y upward.
struct Point {
    double x = 0, y = 0;
    bool operator==(const Point&) const = default;
};

/// Example: distance(Point{0, 0}, Point{3, 4}) == 5
inline double distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

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

/// The box with sides along the axes around something in space; `empty` when there is nothing.
struct SpaceBox {
    Vector low, high;
    bool empty = true;

    void add(const Vector& point);
    void add(const SpaceBox& box);
    /// From `low` to `high`; 0 for nothing.
    double diagonal() const;
    bool operator==(const SpaceBox&) const = default;
};

// -------------------------------------------------------------------------------------------------
// Colours

/// A colour, each part from 0 to 1.
struct Colour {
    double red = 0, green = 0, blue = 0;
    bool operator==(const Colour&) const = default;
};

/// The colour of a name or a hexadecimal code: `black`, `darkgreen`, `#080`, `#008000`. Names are
/// those of CSS, in any case.
///
/// Throws Error with the nearest name if there is no such colour.
///
/// Example: colour_named("#ff0000") == colour_named("red")
Colour colour_named(std::string_view text);

/// The names, in alphabetical order.
///
/// Example: colour_names().front() == "aqua"
std::vector<std::string_view> colour_names();

/// The pure colour of a hue in degrees: 0 red, 120 green, 240 blue, 360 red again.
///
/// Example: hue(120) == colour_named("lime")
Colour hue(double degrees);

/// The names of what stands for many colours, each for its place in the word: `along`, a circle of hues of one lightness;
/// `viridis` and `cividis`, from dark to light, which are told apart in grey and, cividis, by those who do not see red.
///
/// Example: colour_schemes().front() == "along"
const std::vector<std::string>& colour_schemes();

/// Whether this names one of them.
///
/// Example: is_scheme("viridis") && !is_scheme("red")
bool is_scheme(std::string_view name);

/// The colour of a scheme at a share from 0 to 1. Throws Error if there is no such scheme.
///
/// Example: scheme_colour("viridis", 1) == colour_named("#fde725")
Colour scheme_colour(std::string_view scheme, double share);

/// The same hue as light or as dark as it must be to be read on a background: a contrast of 3 to 1 after WCAG 2. Colours that
/// can be read stay as they are.
///
/// Example: readable_on(colour_named("yellow"), colour_named("black")) == colour_named("yellow")
Colour readable_on(const Colour& colour, const Colour& background);

// -------------------------------------------------------------------------------------------------
// Figures in the plane

/// What a figure is drawn on. A figure calls these in drawing order; a canvas knows picture
/// formats, scales and strokes, a figure knows none of them. Widths, colours and the position along
/// the word are nothing to a canvas that does not say otherwise.
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
    virtual void width(double /*factor*/) {}
    /// The same as a length in the units of the file.
    virtual void width_as_length(double /*length*/) {}
    /// The index of the colour in the figure's list, from here on.
    virtual void colour(std::uint32_t /*index*/) {}
    /// A colour that is in no list, from here on.
    virtual void paint(const Colour& /*colour*/) {}
    /// How far along the word the figure is, from 0 to 1: for a hue that runs with it, and for
    /// progress. Called before each stroke or polygon if `wants_position()`.
    virtual void position(double /*fraction*/) {}
    virtual bool wants_position() const { return false; }
    /// The figure's own line width in the units of the file; 0 if the canvas has none.
    virtual double line_width() const { return 0; }
};

/// Strokes that a figure draws again and again in the same direction, each time from another place.
struct StrokeBlock {
    struct Stroke {
        Point to;             // seen from where the block begins, in the units of the figure
        bool lifted = false;  // the pen is set down there: no stroke
    };
    std::size_t number = 0;  // among the blocks of a drawing, from 0 on
    std::vector<Stroke> strokes;
};

/// A canvas that keeps what it makes of a block. A figure that has blocks may send them in place of their strokes; it
/// changes neither width nor colour then.
class BlockCanvas : public Canvas {
public:
    /// Draws the strokes of a block that begins at `from`, where the pen stands.
    virtual void block(const StrokeBlock& block, Point from) = 0;
};

/// One coordinate of a point of a figure: an algebraic number, or a double where the system does not
/// allow more. Prints correctly rounded decimals.
class Coordinate {
public:
    enum class Part { real, imaginary };

    /// offset + factor * part of `number`, exact.
    Coordinate(const CyclotomicRing& ring, CyclotomicInteger number, Part part, Rational factor,
               Rational offset);
    explicit Coordinate(double value) : value_(value) {}

    bool is_exact() const { return exact_.has_value(); }
    double value() const { return value_; }
    /// The rational number it is, if it is known to be one.
    std::optional<Rational> rational() const;
    /// Rounded to so many digits after the point.
    std::string decimal(int digits) const;
    /// An integer or a decimal of at most `digits` digits after the point, without trailing zeros.
    std::string text(int digits = 6) const;

private:
    struct Exact {
        CyclotomicRing ring;
        CyclotomicInteger number;
        Part part;
        Rational factor, offset;
    };
    std::optional<Exact> exact_;
    double value_ = 0;
};

/// What is known of a drawing without drawing it.
struct Facts {
    Integer segments;                   // drawn, with multiplicity
    std::vector<Coordinate> end;        // where the turtle stops: x, y
    std::vector<Coordinate> low, high;  // the box around what is drawn; empty if nothing is
    bool exact = false;                 // whether the coordinates are exact numbers
    double step = 1;                    // length of a segment, before any change of scale; of the
                                        // shortest where lengths are parameters
    double widest = 0;  // of the strokes whose width is a length, that of the widest
    std::string
        rounded;  // why parameters were rounded while the word was derived; empty if they were exact
};

/// How the lines of a figure want to be drawn. Whatever nobody says is absent here and has the value given in the
/// comment.
struct FigureStyle {
    std::vector<std::string> colours;  // as in Drawing; black
    std::optional<Quantity> width;     // in points of the picture; 1
    std::optional<Quantity> narrow;    // factor of the symbol ! on the line width; ! ignored
};

/// What the settings of a file say of it.
///
/// Example: style_of(read_lsystem("axiom F; colour red", "").drawing).colours.size() == 1
FigureStyle style_of(const Drawing& drawing);

/// A drawing of one generation of a system, ready to be sent to a canvas as often as one likes.
/// It holds the rules, not the strokes: drawing streams, and takes memory for one path down the
/// derivation only.
class Figure {
public:
    virtual ~Figure() = default;

    /// The box around everything that is drawn (strokes and polygons, not invisible moves),
    /// without line widths. Empty if nothing is drawn.
    virtual const Box& box() const = 0;
    /// How many segments are drawn, with multiplicity; polygons do not count.
    virtual const Integer& segments() const = 0;
    /// The same and more, as exactly as the system allows.
    virtual const Facts& facts() const = 0;
    /// The lines and polygons this figure sends to a canvas at most, or nothing if the bound is
    /// not known to fit 64 bits.
    virtual std::optional<std::uint64_t> strokes() const = 0;
    /// How this figure wants to be drawn, unless the caller knows better.
    virtual const FigureStyle& style() const = 0;

    /// Draws everything. A part of the derivation whose drawing lies within `resolution` (in the
    /// figure's own units, 0 for none) of the straight way from its start to its end may be replaced
    /// by that stroke, or left out where the same part was drawn at the same place
    /// before: then the work depends on box and resolution, not on the length of the word.
    /// Throws Error if brackets or braces do not match, with the generation and the position, counted from 0.
    virtual void draw(Canvas& canvas, double resolution, const Budget& budget) const = 0;

    /// Whether what is drawn later hides what is drawn before: a picture of something in space. Then
    /// `resolution` is the size of a pixel or a point, and says how fine its facets are.
    virtual bool is_layered() const { return false; }
    /// Where a point of what is drawn lies in the plane, or nothing if it lies nowhere. A figure in
    /// the plane has no points above it.
    virtual std::optional<Point> place(const Vector& point) const {
        return point.z == 0 ? std::optional(Point{point.x, point.y}) : std::nullopt;
    }
    /// Whether lengths are the same everywhere in the figure.
    virtual bool has_scale() const { return true; }
};

/// What is drawn where a system leaves a choice.
struct FigureChoices {
    std::optional<std::uint64_t> seed;  // none: 1 for systems with probabilities
    std::vector<std::size_t> tables;    // one for each step; none: by the schedule or the seed
    bool random_tables = false;         // by the seed, even if there is a schedule
};

/// The figure of generation `n` of a system, derived as Rewriting says where it is no D0L system.
/// Systems without parameters have exact figures wherever their angles and steps allow it.
///
/// Throws Error if the system is not one that a turtle in the plane can draw, or leaves a choice
/// that nobody made (the message names the rule or symbol), BoundReached if the budget does not
/// suffice. For D0L systems O(n * size of the rules) exact operations, for others the length of
/// the words.
std::unique_ptr<Figure> figure(const Model& system, std::uint64_t n, const Budget& budget,
                               const FigureChoices& choices = {});

/// The figure of one word of a system, drawn as its generation `n` is.
std::unique_ptr<Figure> figure(const Model& system, const Word& word, std::uint64_t n,
                               const Budget& budget);

/// The same of a word of modules over these kinds. The seed is for interpretations that have
/// probabilities. Exact where nothing in the word or the system has parameters.
std::unique_ptr<Figure> figure(const Model& system, const ModuleKinds& kinds, ModuleString word,
                               std::uint64_t n, std::uint64_t seed, const Budget& budget);

// -------------------------------------------------------------------------------------------------
// The words that a turtle walks over, and the environments that they ask
//
// A walk throws Error, with the generation, the module and its position, for brackets or braces that do not
// match, an amount that makes no sense, a position that is not finite, a heading that is vertical where it
// is to be levelled, and interpretations that never end; and what budget.check throws.

/// A word for a turtle to walk.
struct DerivedModules {
    ModuleKinds kinds;
    ModuleString word;
    std::uint64_t seed = 1;  // for interpretations with probabilities
    std::string rounded;     // why parameters were rounded on the way; empty if they were exact
};

/// The figure of a word that was derived as generation `n`, in the plane.
std::unique_ptr<Figure> figure(const Model& system, DerivedModules derived, std::uint64_t n,
                               const Budget& budget);

/// The word of generation `n` with its parameters, derived as Rewriting says.
///
/// Its numbers are exact on the way, and the nearest doubles at the end, as long as exactness costs little: while all words
/// together have at most 20,000 modules, the operations that doubles do not do exactly are at most 2,000 (those of enclosures
/// count tenfold), no number has more than 10,000 digits, and enclosures decide every comparison. Otherwise they are doubles all
/// the way from the axiom, and `rounded` says why. So they are where an environment answers with measures of a figure.
///
/// Throws what Rewriting throws, and Error if a turtle cannot draw the word, or a choice is left that
/// nobody made: shape rules, communication modules, tables or several rules for a letter.
///
/// Example: derived_modules(read_lsystem("axiom A(1); A(x) -> F(x)A(x*2)", ""), 3, {}).word.kinds.size() == 4
DerivedModules derived_modules(const LSystem& system, std::uint64_t n, const FigureChoices& choices,
                               const Budget& budget = {});

/// A straight line that a turtle draws, and the module of the word that it belongs to.
struct Segment {
    Vector from, to;
    std::size_t module = 0;  // its position in the word

    bool operator==(const Segment&) const = default;
};

/// What a communication module asks: where the turtle is when it comes to it, and with which
/// parameters.
struct Query {
    std::string name;                // of the module: "?E"
    std::size_t module = 0;          // its position in the word
    std::vector<double> parameters;  // before they are filled
    Vector position;
    Attitude attitude;
};

/// The way of a turtle over a word: what it draws and what it is asked on the way.
struct Traversal {
    std::uint64_t generation = 0;
    std::vector<Segment> segments;  // in the order of the word
    std::vector<Query> queries;     // likewise

    /// Whether some segment leaves the plane z = 0. What is up is z then, and y otherwise.
    bool is_in_space() const;
};

/// What fills the parameters of communication modules (Mech and Prusinkiewicz 1996).
class Environment {
public:
    virtual ~Environment() = default;

    /// For each of these queries of the course the new parameters, as many as it has. Called once a
    /// generation, in the order of generations. Throws Error, naming generation and module, if
    /// something goes wrong.
    virtual std::vector<std::vector<double>> answers(const Traversal& course,
                                                     std::span<const Query* const> queries,
                                                     const Budget& budget) = 0;
};

/// A communication module is left to a program and there is none.
struct ProgramWanted : Error {
    using Error::Error;
};

/// Whether a module of the system is left to an external program.
bool asks_program(const LSystem& system);

class Environments;
class LineProcess;

/// An environment that is another program: it reads a line of JSON for each generation, from 0 on,
///
///     {"generation":0,"queries":[{"module":"?E","index":7,"parameters":[0],"position":[0,1,0],
///      "heading":[0,1,0],"left":[-1,0,0],"up":[0,0,1]}]}
///
/// (all in one line) and writes a line with an answer to each query, in the same order, as many
/// numbers as the module has parameters:
///
///     {"answers":[[1]]}
///
/// `index` is the position of the module in the word. The program is run by /bin/sh -c. It is ended with
/// this object: it gets two seconds to go after its input ends, none if an answer went wrong.
class ExternalEnvironment : public Environment {
public:
    /// An answer may take a minute where the budget has no deadline.
    explicit ExternalEnvironment(const std::string& command);
    ExternalEnvironment(const std::string& command, std::chrono::milliseconds wait);
    ~ExternalEnvironment() override;

    std::vector<std::vector<double>> answers(const Traversal& course,
                                             std::span<const Query* const> queries,
                                             const Budget& budget) override;

private:
    std::string command_;
    std::unique_ptr<LineProcess> program_;
    std::chrono::milliseconds wait_;
};

/// The words of an open L-system, one after the other (Mech and Prusinkiewicz 1996): before each step
/// the turtle walks the word, each communication module asks its environment, and the answers become
/// its parameters; then the word is rewritten as always. Words are shown as they are rewritten, with
/// their parameters filled; that of generation 0 is the axiom with its parameters filled.
///
/// Systems without communication modules develop as by Rewriting alone, and no turtle walks.
class OpenDevelopment {
public:
    /// `external` answers the modules that the file leaves to a program; it may be missing where there
    /// are none. Throws what Rewriting throws, Error if a module has no environment, ProgramWanted if
    /// it is left to a program and `external` is missing.
    OpenDevelopment(const Model& system, const RewritingChoices& choices,
                    std::shared_ptr<Environment> external = nullptr, const Budget& budget = {});

    /// The word of this generation, filled.
    const ModuleString& word() const { return word_; }
    std::uint64_t generation() const { return generation_; }
    const CompiledRules& rules() const { return rewriting_.rules(); }

    /// Goes on to generation n, by the tables in `tables`, one for each step from generation 0 on, or by
    /// its own ones where there are none. Throws what Rewriting::next, a walk and the environments
    /// throw.
    void go_to(std::uint64_t n, const std::vector<std::size_t>& tables = {},
               const Budget& budget = {});

private:
    void fill(const Budget& budget);

    std::shared_ptr<const Model> system_;
    Rewriting rewriting_;
    std::shared_ptr<Environments> environments_;
    std::uint64_t seed_;
    bool is_open_ = false;  // some module communicates
    ModuleString word_;
    std::uint64_t generation_ = 0;
};

/// The word of generation n of any system: of one with communication modules that of
/// OpenDevelopment, of others what derived_modules gives. Throws what these throw, and Error if the
/// system has tables and nobody says which.
DerivedModules open_modules(const Model& system, std::uint64_t n, const FigureChoices& choices,
                            std::shared_ptr<Environment> external, const Budget& budget);

/// The figure of generation n of any system: of one with communication modules that of the word of
/// OpenDevelopment, of others what `figure` gives. Throws what these throw, and Error if the system
/// has tables and nobody says which.
std::unique_ptr<Figure> open_figure(const Model& system, std::uint64_t n, const Budget& budget,
                                    const FigureChoices& choices = {},
                                    std::shared_ptr<Environment> external = nullptr);

/// The way of a system from a generation to the next, as smooth growth (Prusinkiewicz and Lindenmayer 1990, chapter 6, gives ages to
/// modules for it; here their rules say what grows).
///
/// At the share 0 of the way the figure is that of generation n, at 1 that of generation n+1, and it moves without a jump between them:
///
/// - A module that stays is drawn as it is. Of one whose successor has its letter once outside brackets, `F(x) -> F(1.1*x)[+F(1)]`, that
///   letter is itself grown older: its parameters go from the old ones to the new ones.
/// - What is new beside it, and all that a module makes which draws nothing, begins with the length 0; turns outside brackets begin with
///   the angle 0, those inside have all of it, so that branches come out sideways.
/// - A stroke that becomes several, `F -> F+F--F+F`, begins as these in a straight line, together as long as it was.
///
/// A turn that becomes another turn, and what becomes nothing, jumps at the beginning. Widths and colours are those of generation n+1.
class ContinuousDevelopment {
public:
    /// From the word of generation n on. Throws what Rewriting throws, and Error for a system with shape rules or communication modules, or
    /// one that leaves a choice which `choices` does not make. Linear in the lengths of both words.
    ContinuousDevelopment(const Model& system, std::uint64_t n, const FigureChoices& choices,
                          const Budget& budget);
    ~ContinuousDevelopment();

    /// The word of commands at a share of the way, from 0 to 1, drawn as generation n + 1 of `system()` is. Throws what a walk throws.
    ///
    /// Example: ContinuousDevelopment(read_lsystem("axiom F; F -> FF", ""), 0, {}, {}).at(0.5).word.values[1] == 0.75
    DerivedModules at(double share, const Budget& budget = {}) const;

    /// The settings of the system, with all that turtles understand and no rules to interpret it by.
    const Model& system() const;

private:
    struct Way;
    std::unique_ptr<const Way> way_;
};

// -------------------------------------------------------------------------------------------------
// What is left on the paper

/// How many different segments and end points of segments a figure has. Points are the same when
/// they round to the same point of a fine grid, a millionth of a step, so that doubles that stand
/// for the same number count once.
struct Trace {
    std::uint64_t distinct_segments = 0;  // direction does not matter
    std::uint64_t vertices = 0;
};

/// Draws the figure once, in memory for every segment: throws BoundReached if that is more than
/// budget.memory.
Trace trace(const Figure& figure, const Budget& budget);

/// What a figure leaves on the paper: different strokes between different points, whatever their
/// order, direction, number, colour and width, and the filled polygons.
struct Outline {
    using Stroke = std::pair<std::uint32_t, std::uint32_t>;  // numbers of points, the smaller first

    /// The same points as numbers of Z[zeta_m], seen from the start and measured in steps.
    struct Lattice {
        CyclotomicRing ring;
        std::vector<CyclotomicInteger> points;
        std::optional<Rational> unit;  // the length of a step, where it is rational
    };

    std::vector<std::complex<double>> points;
    std::vector<Stroke> strokes;                       // increasing
    std::vector<std::vector<std::uint32_t>> polygons;  // corners in increasing order; increasing
    std::optional<Lattice> lattice;                    // where all of it is exact
};

/// The outline of generation `n`. Exact for D0L systems whose angles are exact, that do not change
/// the length of a step within a figure and fill nothing. Throws what `figure` throws, BoundReached
/// if there are more than a million strokes. The length of the word times the degree of the ring.
Outline outline(const Model& system, std::uint64_t n, const Budget& budget = {},
                const FigureChoices& choices = {});

/// Whether two outlines are the same but for a motion of the plane, its mirror images, and size.
struct Similarity {
    bool similar = false;
    bool same_size = false;   // then they are congruent
    bool same_place = false;  // then they are the same, to a ten millionth of their size
    bool exact =
        false;  // decided by numbers that are not rounded; otherwise to a ten millionth of the figure
    std::string difference;  // a sentence, where they are not similar
};

/// Compares strokes with strokes and polygons with polygons: a stroke is not the same as two that make
/// it up. Names are for the sentence. A motion is looked for in doubles, from the farthest point from the
/// middle to each point as far from the middle of the other; what is found is proved in the ring where
/// both are exact, by (p - p0)(q1 - q0) = (q - q0)(p1 - p0) for all points p and their images q.
/// Linear in the strokes for each such pair of points.
Similarity similarity(const Outline& left, const std::string& left_name, const Outline& right,
                      const std::string& right_name);

// -------------------------------------------------------------------------------------------------
// Commands of a turtle in the plane; its Compass and LatticeMotions are in lattice_motions.hpp

/// One thing a turtle in the plane does (Prusinkiewicz and Lindenmayer 1990, 1.3 and appendix).
enum class Command : unsigned char {
    draw,           // F, F_x: a step with the pen down
    draw_unmarked,  // G: the same, but no vertex of a polygon
    move,           // f, f_x: a step with the pen up
    left,           // +
    right,          // -
    back,           // |
    push,           // [
    pop,            // ]
    open_polygon,   // {
    close_polygon,  // }
    vertex,         // .
    scale,          // * where the file sets `scale`
    narrow,         // ! where the file sets `narrow`
    next_colour,    // '
    cut,            // %: the rest of the branch is left out
};

/// Whether the name alone tells a turtle something, with or without a number: F, f_x, G, +, [ and so on.
///
/// Example: is_turtle_name("F_a") && !is_turtle_name("A")
bool is_turtle_name(const std::string& name);

/// What each symbol makes the turtle do, after `interpret` rules, applied again and again until
/// only symbols without one are left. Symbols that mean nothing to a turtle have no commands.
class Commands {
public:
    /// Throws Error if a symbol asks for a turtle in space (& ^ \ / and so on) or leaves a surface, if the
    /// interpretation goes round in circles, or needs more than plain rules.
    explicit Commands(const Model& system, const std::vector<Symbol>& letters);

    const std::vector<Command>& of(Symbol a) const { return commands_[a]; }
    /// Whether any of the letters has this command.
    bool uses(Command command) const { return used_[static_cast<std::size_t>(command)]; }

private:
    std::vector<std::vector<Command>> commands_;
    bool used_[16] = {};
};

/// The product of a letter's commands, branches within it included. `value_of` gives the image of
/// one command other than push and pop.
template <Branching M, class ValueOf>
typename M::value_type product(const M& monoid, const std::vector<Command>& commands,
                               ValueOf value_of) {
    std::vector<typename M::value_type> open{monoid.one()};
    for (const Command command : commands) {
        if (command == Command::push) {
            open.push_back(monoid.one());
        } else if (command == Command::pop && open.size() > 1) {
            const auto twig = monoid.branch(open.back());
            open.pop_back();
            monoid.append(open.back(), twig);
        } else {
            monoid.append(open.back(), value_of(command));
        }
    }
    return open.front();
}

/// How many segments a word draws in which `letters[i]` occurs `counts[i]` times, wherever they
/// stand; with cut branches (`%`) at most as many. O(letters).
Integer drawn_segments(const Commands& commands, const std::vector<Symbol>& letters,
                       const std::vector<Integer>& counts);

// -------------------------------------------------------------------------------------------------
// A walk explained, and shown while it goes on

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
    double susceptibility = 1;    // factor on how far its steps bend to a tropism
    std::uint32_t colour = 0;     // in the list of the file
    std::optional<Colour> paint;  // instead of it, after '(r,g,b)
};

/// A straight way of a turtle, with the pen down or up.
struct ExplainedLine {
    Vector from, to;
    bool drawn = false;
    TurtleState state;  // at its end
};

/// What one symbol of a word makes a turtle do.
struct ExplainedStep {
    std::string symbol;   // as it is printed: "F(2)"
    std::string meaning;  // in words: "forward 2, drawing"
    TurtleState before, after;
    std::size_t open = 0;                   // branches that are open afterwards
    std::optional<std::size_t> returns_to;  // the step that began the branch it ends, from 0
    std::vector<ExplainedLine> lines;
    std::vector<std::vector<Vector>> polygons;
};

/// A turtle's walk over a word, step by step.
struct Explanation {
    std::string name;  // "generation 1 of koch", as messages call it
    std::string word;
    TurtleState start;
    std::vector<ExplainedStep> steps;
};

/// A place or a length for people: rounded to 4 decimals, without zeros at the end.
///
/// Example: rounded(0.1 + 0.2) == "0.3"
/// Example: rounded(-1e-12) == "0"
std::string rounded(double value);

/// The heading in the plane as an angle, 0 along +x and counter-clockwise, from 0 to 360; nothing if
/// it leaves the plane.
///
/// Example: heading_angle(TurtleState{}) == 0.0
std::optional<double> heading_angle(const TurtleState& state);

/// What each symbol of a word does to the turtle, in words that are about what happened: a symbol
/// with an interpretation says all that comes of it. Linear in the length of the word.
///
/// Throws what a walk throws.
Explanation explanation(const Model& system, const ModuleKinds& kinds, const ModuleString& word,
                        std::uint64_t generation, std::uint64_t seed, const Budget& budget = {});

/// The colour of turtles that are drawn.
inline constexpr Colour turtle_green{0.13, 0.45, 0.25};

/// After how many symbols of a word each frame is that shows the turtle at work: 0, then every one or
/// every second and so on, so that there are at most `most` frames (at least 2), and all of them.
///
/// Example: frames_of_progress(3, 10) == std::vector<std::size_t>{0, 1, 2, 3}
/// Example: frames_of_progress(10, 5) == std::vector<std::size_t>{0, 3, 6, 9, 10}
std::vector<std::size_t> frames_of_progress(std::size_t symbols, std::size_t most);

/// The figure of a word after each of these numbers of symbols, which rise; all in one box. Throws
/// what `figure` throws. Linear in the length of the word.
std::vector<std::unique_ptr<Figure>> partial_figures(const Model& system,
                                                     const DerivedModules& derived, std::uint64_t n,
                                                     const std::vector<std::size_t>& symbols,
                                                     const Budget& budget);

// -------------------------------------------------------------------------------------------------
// Figures in space

/// The solids that a turtle may leave where it stands.
enum class SolidShape : std::uint8_t { box, cylinder, cone, sphere };

/// What something is painted with: a colour of its own, or one of the list of its scene.
struct Paint {
    std::uint32_t index = 0;       // in the scene's list, which comes round again
    std::optional<Colour> colour;  // instead of it
    bool operator==(const Paint&) const = default;
};

/// One straight stroke of a turtle: a round rod, or a line where it has no thickness.
struct Rod {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    Vector from, to;
    double radius = 0;      // in the units of the file; 0: a line
    double line_width = 1;  // of a line, as a multiple of the scene's
    Paint paint;
    std::uint32_t before = none;  // the rod at whose end this one begins, if it begins at one
    bool branch = false;          // it begins a branch there, and another rod goes on
};

/// A flat polygon; its corners are a run of the scene's.
struct Face {
    std::uint32_t first = 0, corners = 0;
    Paint paint;
};

/// A solid by its middle, the way it is turned, and its measures. A box has `size` along heading,
/// left and up of `attitude`. A cylinder and a cone have the height `size.x` along the heading and the
/// radius `size.y` (of a cone that of its base, which is behind); a sphere the radius `size.x`.
struct Solid {
    SolidShape shape = SolidShape::box;
    Vector middle;
    Attitude attitude;
    Vector size;
    Paint paint;
};

/// All that is to be seen of a figure in space, in the units of the file: x and y are the plane's,
/// z is up.
struct Scene {
    std::vector<Rod> rods;
    std::vector<Vector> corners;
    std::vector<Face> faces;
    std::vector<Solid> solids;
    std::vector<std::string> colours;  // as in Drawing
    std::string name;                  // "generation 8 of honda", as messages call it

    /// Appends a face with these corners.
    void add_face(std::span<const Vector> points, const Paint& paint);
    std::span<const Vector> corners_of(const Face& face) const {
        return std::span(corners).subspan(face.first, face.corners);
    }
    bool empty() const { return rods.empty() && faces.empty() && solids.empty(); }
    /// How many rods, faces and solids there are.
    std::size_t parts() const { return rods.size() + faces.size() + solids.size(); }
};

/// The smallest box around a solid.
SpaceBox box_of(const Solid& solid);

/// The box around the axes of the rods and around faces and solids: without the thickness of rods.
SpaceBox box_of(const Scene& scene);

/// What is known of a scene without looking at it.
struct SpaceFacts {
    std::uint64_t segments = 0;  // drawn, with multiplicity
    double length = 0;           // of all of them
    SpaceBox box;                // around what is drawn
    double step = 1;             // of the turtle at its start, or the shortest segment
    std::string rounded;         // see Facts
};

/// A turtle's walk through space: what it left, and where it stopped.
struct SpaceDerivation {
    Scene scene;
    TurtleState end;
    SpaceFacts facts;
};

/// Whether figures of the system are scenes: some word of it, or its interpretation, may turn the
/// turtle out of the plane or asks for solids, surfaces that are not flat or plots of three
/// coordinates, or a tropism does, or its rules make boxes. The same for all generations. Linear in the size of the rules.
///
/// Example: leaves_plane(read_lsystem("axiom F+A; A -> &A", ""))
/// Example: !leaves_plane(read_lsystem("axiom F+A; A -> +A; B -> &", ""))
bool leaves_plane(const Model& system);

/// Generation `n` of a system in space, derived as open_modules says, walked by a turtle; of a
/// system of shape rules its boxes.
///
/// Widths by `!(w)` are diameters: such rods have the radius w/2. Others are lines, as wide as their
/// multiple of the scene's line width. Of the rods that begin where one ends all but one are
/// branches: that is the one in the same brackets, or the first of those in the fewest.
///
/// Throws what open_modules, boxes_after and a walk throw, and BoundReached if the scene takes more than
/// budget.memory. Linear in the length of the word.
///
/// Example: scene(read_lsystem("axiom F^(90)F(2)", ""), 0, {}).end.position == Vector{1, 0, 2}
SpaceDerivation scene(const Model& system, std::uint64_t n, const Budget& budget,
                      const FigureChoices& choices = {},
                      std::shared_ptr<Environment> external = nullptr);

/// The same for one word of modules over these kinds, drawn as generation `n` is. The seed is for
/// interpretations that have probabilities.
SpaceDerivation scene(const Model& system, const ModuleKinds& kinds, const ModuleString& word,
                      std::uint64_t n, std::uint64_t seed, const Budget& budget);

/// How many different segments and ends of them a scene has; see trace of a Figure.
Trace trace(const SpaceDerivation& derivation, const Budget& budget);

// -------------------------------------------------------------------------------------------------
// How a camera sees them

/// Where a figure in space is looked at from. It always looks at the middle of the figure, with z
/// upward, from so far that all of it is seen.
struct Camera {
    double azimuth = -60;   // where the camera stands: degrees from +x towards +y, seen from above
    double elevation = 15;  // degrees above the horizon, -90 to 90
    bool perspective = false;  // near things are larger
    double opening = 40;  // of a perspective: degrees of the cone that holds the figure, 1 to 170

    bool operator==(const Camera&) const = default;
};

/// Throws Error, naming what is wrong, unless all angles are finite and within the bounds above.
void check_camera(const Camera& camera);

/// A point as a camera sees it: its place in the plane, how near it is (larger is nearer) and how
/// much larger than far away things look there. Straight lines stay straight and planes plane, in
/// perspective too: depth is measured so.
struct Seen {
    double x = 0, y = 0, depth = 0, scale = 1;
    bool operator==(const Seen&) const = default;
};

/// What a camera makes of points. In perspective, lengths in the middle of the figure stay what they
/// are (Foley, van Dam, Feiner and Hughes 1990, 6.5).
class Projection {
public:
    /// Sees everything in the box. Throws Error as check_camera.
    Projection(const Camera& camera, const SpaceBox& box);

    Seen operator()(const Vector& place) const {
        const double across = dot(right_, place), up = dot(up_, place), near = dot(toward_, place);
        if (distance_ == 0) return {across, up, near, 1};
        const double scale = distance_ / (distance_ - (near - near_));
        return {across_ + (across - across_) * scale, upward_ + (up - upward_) * scale,
                near_ + (near - near_) * scale, scale};
    }
    /// The corners of the box around the outline of a ball, as it is seen. Away from the middle of a
    /// perspective the outline is an ellipse around another place than its middle's.
    std::pair<Point, Point> outline(const Vector& middle, double radius) const;
    /// The unit vector from a place towards the camera.
    Vector to_camera(const Vector& place) const {
        if (distance_ == 0) return toward_;
        return unit(eye_ - place);
    }
    /// What is to the right, upward and toward the camera in the picture.
    const Vector& right() const { return right_; }
    const Vector& up() const { return up_; }
    const Vector& toward() const { return toward_; }

private:
    Vector right_, up_, toward_, eye_;
    double distance_ = 0;                        // of the camera from the middle; 0: from far away
    double across_ = 0, upward_ = 0, near_ = 0;  // of the middle
};

/// Where the light comes from, as a camera is placed: azimuth and elevation in degrees.
struct Light {
    double azimuth = 0, elevation = 0;
    bool operator==(const Light&) const = default;
};

/// How a scene is looked at.
struct ViewChoices {
    Camera camera;
    std::optional<Light> light;  // none: over the camera's left shoulder
    double fog = 0;              // the share of the background in what is farthest
    Colour background{1, 1, 1};  // what is behind the scene
    /// What is kept free beside lines without thickness where they pass in front of others, as a
    /// multiple of the line width. None: 1 for a scene without branches, otherwise 0.
    std::optional<double> gap;
    /// What the camera is set up for, and the fog. None: the scene.
    std::optional<SpaceBox> sight;
};

/// How the settings of a file want their scenes to be looked at.
///
/// Example: view_choices(read_lsystem("axiom F; camera 30 20", "").drawing).camera == Camera{30, 20}
ViewChoices view_choices(const Drawing& drawing);

/// What is known of a scene that its rods do not tell.
struct SceneFacts {
    Vector end;           // where the turtle stopped
    double step = 1;      // the turtle's, at its start
    std::string rounded;  // see Facts
};

/// A picture of a scene: what a camera sees of it, in the light, in the plane's units. What is in
/// front hides what is behind.
///
/// Things are convex: pieces of rods, solids, polygons. They are painted in the order that
/// painting_order finds; those that hide each other in a ring are halved until an order is right, a
/// few times at most. Tubes and balls are drawn in facets as fine as the picture shows.
class SpaceView : public Figure {
public:
    /// Throws Error on a camera, light or fog out of bounds, BoundReached if the scene takes more than
    /// the budget's memory.
    SpaceView(Scene scene, const FigureStyle& style, const SceneFacts& facts,
              const ViewChoices& choices, const Budget& budget);

    const Box& box() const override { return box_; }
    const Integer& segments() const override { return facts_.segments; }
    /// Box and end have three coordinates: those of the scene.
    const Facts& facts() const override { return facts_; }
    std::optional<std::uint64_t> strokes() const override { return scene_.parts(); }
    const FigureStyle& style() const override { return style_; }
    void draw(Canvas& canvas, double resolution, const Budget& budget) const override;
    bool is_layered() const override { return true; }
    std::optional<Point> place(const Vector& point) const override;
    bool has_scale() const override { return !choices_.camera.perspective; }

    const Scene& scene() const { return scene_; }
    const Projection& projection() const { return projection_; }

private:
    Scene scene_;
    FigureStyle style_;
    ViewChoices choices_;
    Projection projection_;
    Facts facts_;
    Box box_;
    double farthest_ = 0, nearest_ = 0;
    std::vector<std::uint32_t> next_;  // by rod: the one that goes on where it ends
    std::vector<char> adjoins_;  // by corner: another polygon goes on at the edge that begins there
    bool branches_ = false;
};

/// The view of a word in space after each of these numbers of symbols, which rise, with the turtle
/// where it is; all in one box and seen by one camera. Each is made anew when it is drawn, so there is
/// memory for two scenes at a time.
///
/// Throws what `scene` and SpaceView throw. Drawing is linear in the length of the word
/// and whatever SpaceView takes.
std::vector<std::unique_ptr<Figure>> partial_views(const Model& system,
                                                   const DerivedModules& derived, std::uint64_t n,
                                                   const std::vector<std::size_t>& symbols,
                                                   const ViewChoices& choices,
                                                   const Budget& budget);

/// A scene as these cameras see it, one after the other, as large in every picture and with its middle at the same place: the
/// frames of a turntable. Each is made anew when it is drawn, so there is memory for two scenes at a time.
///
/// Throws what SpaceView throws. O(parts) for each camera.
std::vector<std::unique_ptr<Figure>> turned_views(const SpaceDerivation& derivation,
                                                  const FigureStyle& style,
                                                  const ViewChoices& choices,
                                                  const std::vector<Camera>& cameras,
                                                  const Budget& budget);

// -------------------------------------------------------------------------------------------------
// Scenes as triangles

/// How thick things without thickness become where they must have some, and what counts as nothing.
struct Thickness {
    double line = 0;  // the radius of a line of the scene's own width
    double least =
        0;  // the radius of anything thinner; rods shorter than a tenth of it are left out
};

/// Lines become as thick as 1/500 of the diagonal of the box around the scene, or, if that is less,
/// as a quarter of their mean length. Nothing is thinner than a millionth of the largest coordinate
/// or diagonal, which is about what the numbers of single precision in files can tell apart.
Thickness thickness(const Scene& scene);

/// Rods that go on from one another without a gap or a sharp turn, as one bent tube.
struct Limb {
    std::uint32_t first = 0, nodes = 0;  // in Limbs::nodes; at least 2
    bool round_foot = false, round_end = false;
};

/// The limbs of a scene, each a run of nodes.
struct Limbs {
    struct Node {
        Vector point;
        double radius = 0;
        std::uint32_t rod = 0;  // the one that begins here; at the last node the one that ends here
    };
    std::vector<Node> nodes;
    std::vector<Limb> limbs;

    std::span<const Node> nodes_of(const Limb& limb) const {
        return std::span(nodes).subspan(limb.first, limb.nodes);
    }
};

/// Joins the rods of a scene into limbs.
///
/// A rod goes on from the one before it unless it is a branch (or is the only rod there). At the joint
/// both have the radius of the one that goes on. A limb ends flat where nothing is to be hidden. Its
/// end is round where branches begin and nothing goes on, at turns of more than 120 degrees, and where
/// a mitre would cut away more than half of a rod; its foot is round where it is wider than what it
/// begins in. Rods in one straight line of one radius and paint become one piece.
///
/// Throws Error if a coordinate or radius is not finite. O(rods) time and memory.
Limbs limbs_of(const Scene& scene, const Thickness& thickness, const Budget& budget);

/// Whether a limb is one straight piece of one radius that ends flat at both ends.
bool is_cylinder(const Limbs& limbs, const Limb& limb);

/// A scene as triangles.
///
/// First come closed surfaces, each wound counter-clockwise seen from outside: every directed edge
/// between points is in one triangle and its reverse in one. Then come sheets, the polygons of the
/// scene, to be seen from both sides.
struct Mesh {
    /// A corner of triangles: where it is, which way its surface looks there, what it is painted
    /// with. Several corners share a point where the surface has an edge or changes its paint.
    struct Corner {
        std::uint32_t point = 0;  // in `points`
        std::uint32_t paint = 0;  // in `paints`
        Vector normal;            // of length 1
    };
    using Triangle = std::array<std::uint32_t, 3>;  // in `corners`

    std::vector<Vector> points;
    std::vector<Corner> corners;
    std::vector<Triangle> triangles;
    std::size_t closed = 0;  // so many of the triangles, from the first, belong to closed surfaces
    std::vector<Paint> paints;

    const Vector& place(std::uint32_t corner) const { return points[corners[corner].point]; }
};

struct MeshOptions {
    /// Sides of a tube, from 3 to 256; a solid that is round has twice as many.
    unsigned facets = 8;
    /// Surfaces that meet at less than this angle, in degrees, are shaded as one smooth surface.
    double crease = 40;
    /// Whether rods that are cylinders (see is_cylinder) and solids become triangles too.
    bool cylinders = true, solids = true;
};

/// The triangles of a scene.
///
/// Rods that go on from one another become one tube (see Limbs) whose cross section is carried along
/// without twist (the rotation-minimising frame: reflections in the planes of the mitres, after Wang
/// et al., Computation of rotation minimizing frames, 2008), narrowing along each rod to the width
/// of the next, with mitred joints and closed ends. A tube is inscribed in the round one: k facets
/// hold k/(2 pi) sin(2 pi/k) of its volume. Rods without radius and measures of 0 of solids become
/// as thick as `thickness` says. Polygons are triangulated as `polygon_triangles` does; those with
/// a common corner are smooth there unless they meet at an edge sharper than the crease.
///
/// Throws Error on options out of range, on coordinates or measures that are not finite, and if there
/// is nothing to be seen; BoundReached if the mesh would have 2^32 corners or need more memory
/// than the budget has, before it is built. O(rods * facets) time.
Mesh mesh_of(const Scene& scene, const MeshOptions& options, const Budget& budget);

/// The box around all points.
SpaceBox box_of(const Mesh& mesh);

}  // namespace algae
