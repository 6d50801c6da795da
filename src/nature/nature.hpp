#pragma once

// nature: the other generators of natural geometry, each as a Generator that has Figures: iterated
// function systems, cellular automata, walks and Brownian paths, landscapes, aggregates, particles,
// graphs of functions, and sets covered with boxes.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dimension/dimension.hpp"
#include "exact/exact.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"

namespace algae {

struct Model;

/// One picture of a generator: what messages call it, and what is written underneath.
struct GeneratorFigure {
    std::unique_ptr<Figure> figure;
    std::string name, caption;
};

/// Something that is known of a generator: `key` in JSON, with the value there; on a page the key
/// with blanks for underscores, and the text.
struct GeneratorFact {
    std::string key, text;
    std::shared_ptr<const nlohmann::ordered_json> value;  // never null

    GeneratorFact(std::string of, std::string said, const nlohmann::ordered_json& known);
};

/// A generator of natural geometry that is not an L-system: an iterated function system, an
/// automaton, a path of Brownian motion. What it gives depends on itself alone: random ones hold
/// their seed.
class Generator {
public:
    virtual ~Generator() = default;

    /// What messages call it, usually the name of its file.
    std::string name;
    /// As in .lsys files; may be empty.
    std::string title, source;
    /// The title, or the name where there is none.
    std::string heading() const { return title.empty() ? name : title; }
    /// How its figures want to be drawn: `colour` and `width`.
    FigureStyle style;

    /// The pictures that a page of it shows, at least one. Throws what making them throws.
    virtual std::vector<GeneratorFigure> figures(const Budget& budget) const = 0;

    /// The pictures of an animation of it; those of the page where it says nothing else.
    virtual std::vector<GeneratorFigure> frames(const Budget& budget) const {
        return figures(budget);
    }
    /// The one whose dimension is measured: the last of its figures.
    virtual GeneratorFigure measured_figure(const Budget& budget) const {
        return std::move(figures(budget).back());
    }
    /// What is known of its dimension without measuring, if anything.
    virtual std::optional<ExactDimension> exact_dimension(const Budget&) const {
        return std::nullopt;
    }
    /// What is worth saying of it, in the order of a page.
    virtual std::vector<GeneratorFact> facts(const Budget&) const { return {}; }
    /// The same in space, for those that lie there.
    virtual std::optional<Scene> scene(const Budget&) const { return std::nullopt; }
};

// Iterated function systems.

/// The affine map (x,y) -> (a x + b y + e, c x + d y + f) of the plane.
struct AffineMap {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    Point operator()(Point p) const { return {a * p.x + b * p.y + e, c * p.x + d * p.y + f}; }
    bool operator==(const AffineMap&) const = default;
};

/// An iterated function system: finitely many maps of the plane that bring points together. There
/// is exactly one set, not empty and compact, that is the union of its images under them, the
/// attractor (Hutchinson 1981; Barnsley, Fractals Everywhere, 1988).
///
/// With several states it is graph-directed (Mauldin and Williams 1988): a set K_i for each state,
/// the union of the images of the sets K_to under the maps of the state i. The attractor is that of
/// the first state.
class IteratedFunctions : public Generator {
public:
    struct Map {
        std::array<Quantity, 6> numbers;  // a b c d e f, as exact as they are written
        AffineMap map;
        std::size_t from = 0, to = 0;  // states
        std::optional<Quantity> probability;
        std::optional<Expression> ratio;  // where it is a similarity: of distances, exactly
        std::string name;                 // "map 2", as messages call it
        /// How it was written, if as ratio and degrees.
        std::optional<std::pair<Quantity, Quantity>> similarity;
    };

    std::vector<std::string> states{""};
    std::vector<Map> maps;  // in the order of the file; its number is the index of its colour

    /// What its figures show: this many points of the chaos game; or the images of a polygon under
    /// the maps, in these generations; or the attractor.
    std::optional<std::uint64_t> points;
    std::optional<std::pair<std::uint64_t, std::uint64_t>> generations;
    std::uint64_t seed = 1;
    std::optional<Point> from;  // where the chaos game begins; the fixed point of the first map
    std::vector<Point> start{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

    /// Throws Error if there are no maps, a map that can come back does not bring points together
    /// (named with its norm), a state has no map, or probabilities are not positive or do not add
    /// up to 1 (with their sum). Call once after the maps are there.
    void check() const;

    /// The largest norm of a map that can come back; of others nothing is asked.
    double contraction() const;
    /// For each state, whether there are maps from it that lead back to it.
    std::vector<bool> recurrent_states() const;
    /// The chances of the maps in the chaos game: those said, or in proportion to the areas they
    /// leave, at least a hundredth of the largest.
    std::vector<double> chances() const;

    std::vector<GeneratorFigure> figures(const Budget& budget) const override;
    /// The attractor, unless points or generations are asked for.
    GeneratorFigure measured_figure(const Budget& budget) const override;
    std::optional<ExactDimension> exact_dimension(const Budget& budget) const override;

    /// The generalised dimensions D_q of the measure that the chances of its maps make, of each order: the solution of
    /// sum p^q r^((1 - q) D_q) = 1 over the maps' chances p and ratios r; for q = 1, sum p log p / sum p log r (Hentschel and Procaccia
    /// 1983; Falconer, Fractal Geometry, 17.3). To about 12 digits. Nothing unless the file gives chances, there is one state, all maps are
    /// similarities, and their parts lie apart (`separation`).
    ///
    /// Throws Interrupted.
    std::optional<std::vector<double>> exact_spectrum(std::span<const double> orders,
                                                      const Budget& budget) const;
    /// The maps with norms, fixed points and probabilities, the contraction, the box of the
    /// attractor, the similarity dimension.
    std::vector<GeneratorFact> facts(const Budget& budget) const override;
};

/// The graph-directed iterated function system whose attractor the curves of a D0L system approach
/// when each generation is drawn as large as the one before: a state for each piece of its
/// recurrent set (a letter, in a phase), maps of the ratio 1/|mu| for its parts (Dekking, Recurrent
/// sets, 1982). If the axiom is more than one letter, the first state is the whole, and its maps
/// only place the parts. The attractor lies as the curve does when the turtle starts at the origin
/// with heading 0 and no generation is turned against the one before: `start` and `spin` are left
/// out.
///
/// Throws what RecurrentSet throws where the system has none, and Error if it is not a D0L system.
IteratedFunctions functions_of_curve(const Model& system, const Budget& budget = {});

/// The attractor as a set of a lattice, for maps that are one linear map after turns and reflections from a finite group: with M^-1 the
/// matrix of the first map and P any of the group, P K is M^-1 times parts of the same kind. Areas are those of the plane.
///
/// Throws Error, with the reason, where numbers are not in one field (`CyclotomicField`), where there is no such M, or where vectors
/// do not lie in a lattice; BoundReached where they need too many digits.
LatticeSet lattice_set(const IteratedFunctions& system, const Budget& budget = {});

/// A tile and its neighbours as polygons (`tile_outlines`), the tile in a strong colour and neighbours that touch each other in different
/// ones as long as these last.
std::unique_ptr<Figure> tile_figure(const Tile& tile, const Budget& budget = {});

// Cellular automata.

/// A cell beside a cell: so many columns to the right and rows downward.
struct CellOffset {
    int column = 0, row = 0;
    bool operator==(const CellOffset&) const = default;
};

/// The rule of a cellular automaton: the states of a cell's neighbourhood decide its next state.
/// The neighbourhood has the cell itself in it; a local configuration is read as a number in base
/// `states`, its first cell the most significant digit, and `table` says the next state for each.
struct CellRule {
    std::uint32_t states = 2;
    int dimensions = 1;
    std::vector<CellOffset> neighbourhood;
    std::vector<std::uint8_t> table;
    std::string text;  // "rule 30", "B3/S23", as captions say

    /// The farthest offset in any direction.
    int radius() const;
    /// Whether it has two states, and a cell and its two neighbours decide.
    bool is_elementary() const;
    bool operator==(const CellRule&) const = default;
};

/// The states of the local configuration of a number, from that of the first cell on.
///
/// Example: local_configuration(6, 2, 4) == std::vector<std::uint8_t>{0, 1, 1, 0}
std::vector<std::uint8_t> local_configuration(std::size_t number, std::uint32_t states,
                                              std::size_t cells);

/// The cells at most `radius` away on a line, from left to right.
std::vector<CellOffset> line_neighbourhood(int radius);

/// Rows of the square of cells at most `radius` away in columns and rows (Moore).
std::vector<CellOffset> moore_neighbourhood(int radius);

/// The cells at most `radius` steps away (von Neumann).
std::vector<CellOffset> neumann_neighbourhood(int radius);

/// The rule of a number, as Wolfram counts them: its digits in base `states`, from the last, are
/// the table. Elementary rules are those of 2 states and radius 1.
///
/// Throws Error if the number is not below states^(states^cells), with the largest that is.
///
/// Example: numbered_rule(Integer(54), 2, line_neighbourhood(1)).table == std::vector<std::uint8_t>{0, 1, 1, 0, 1, 1, 0, 0}
CellRule numbered_rule(const Integer& number, std::uint32_t states,
                       const std::vector<CellOffset>& neighbourhood);

/// The rule that goes by the sum of the states of the neighbourhood alone: digit s of the code, in
/// base `states`, is the next state for the sum s.
CellRule totalistic_rule(const Integer& code, std::uint32_t states,
                         const std::vector<CellOffset>& neighbourhood);

/// The outer-totalistic rule `B3/S23` of two states: a dead cell comes to life with a number of
/// living neighbours behind B, a living one stays so with one behind S; both single digits.
///
/// Throws Error if the text has another form, or names more neighbours than there are.
CellRule life_rule(std::string_view text, const std::vector<CellOffset>& neighbourhood);

/// What stands beyond the edges of a grid: the other side of it, or always the same state.
struct CellBoundary {
    bool periodic = true;
    std::uint8_t outside = 0;
    bool operator==(const CellBoundary&) const = default;
};

/// The states of all cells, row by row.
struct CellGrid {
    std::size_t columns = 0, rows = 1;
    std::vector<std::uint8_t> cells;

    CellGrid() = default;
    /// All 0. Throws Error if there would be more cells than the memory of the budget has bytes, or
    /// none.
    CellGrid(std::size_t columns, std::size_t rows, const Budget& budget);

    std::uint8_t& at(std::size_t column, std::size_t row) { return cells[row * columns + column]; }
    std::uint8_t at(std::size_t column, std::size_t row) const {
        return cells[row * columns + column];
    }
    bool operator==(const CellGrid&) const = default;
};

/// A cellular automaton with the configuration that it starts from: cells on a line or in the
/// plane, all of which take their next state at once, by one rule, from the states of their
/// neighbourhoods.
class CellularAutomaton : public Generator {
public:
    CellRule rule;
    CellBoundary boundary;
    CellGrid start;
    /// On a line the first and the last one shown, below each other; in the plane one picture each.
    std::vector<std::uint64_t> generations{0, 50};
    /// Whether the rule's table stands above the picture.
    bool legend = false;

    std::vector<GeneratorFigure> figures(const Budget& budget) const override;
    /// The rule, the grid, and how many cells are not 0 in the first generations.
    std::vector<GeneratorFact> facts(const Budget& budget) const override;

    /// Generation `first` and those after it up to `last`, one row each. On a line only. Throws
    /// Error if they do not fit in memory.
    CellGrid space_time(std::uint64_t first, std::uint64_t last, const Budget& budget) const;
    /// The configuration of a generation.
    CellGrid generation(std::uint64_t n, const Budget& budget) const;
};

/// The character of a state: 0 to 9, then a to z. At most 36 states have one.
///
/// Example: state_character(11) == 'b'
char state_character(std::uint8_t state);

/// The characters of several states.
///
/// Example: state_text(local_configuration(6, 2, 4)) == "0110"
std::string state_text(std::span<const std::uint8_t> states);

/// The rows of a grid, a character for each cell, with a line break behind each.
std::string grid_text(const CellGrid& grid);

// Walks, Brownian paths and landscapes.

/// A walk whose steps are Gaussian in each coordinate: x(t + 1) = x(t) + Dx, with Dx of mean 0.
struct RandomWalk {
    int dimensions = 2;  // 1, 2 or 3
    std::uint64_t steps = 10000;
    double deviation = 1;  // of each coordinate of a step
    std::uint64_t seed = 1;
};

/// Pictures of the beginnings of one random walk: in one dimension its graph against time, in two
/// its path, in three its path as the usual camera sees it.
class RandomWalks : public Generator {
public:
    RandomWalk walk;                          // `steps` is not used
    std::vector<std::uint64_t> steps{10000};  // a figure for each

    /// Throws Error on a walk out of range or without steps.
    void check() const;

    std::vector<GeneratorFigure> figures(const Budget& budget) const override;
    std::vector<GeneratorFact> facts(const Budget& budget) const override;
    std::optional<Scene> scene(const Budget& budget) const override;
};

/// Fractional Brownian motion X on [0, 1]: Gaussian, X(0) = 0, and
/// var(X(t) - X(s)) = sigma^2 |t - s|^(2H) with 0 < H < 1 (Mandelbrot and Van Ness, SIAM Review 10,
/// 1968). H = 1/2 is Brownian motion. Paths have 2^levels + 1 evenly spaced values.
struct BrownianMotion {
    double hurst = 0.5;
    double sigma = 1;
    int levels = 10;

    static constexpr int most_levels = 24;
};

/// Pictures of fractional Brownian motion: in one dimension the graph of X(t), in two and three the
/// path whose coordinates are independent; one for each H and each number of levels.
class BrownianPaths : public Generator {
public:
    std::vector<double> hurst{0.5};
    double sigma = 1;
    std::pair<int, int> levels{10, 10};
    int dimensions = 1;
    bool exact = true;  // otherwise by midpoint displacement
    std::uint64_t seed = 1;

    /// Throws Error on parameters out of range.
    void check() const;
    /// The coordinates of one path, one after the other.
    std::vector<std::vector<double>> coordinates(double h, int level, const Budget& budget) const;

    std::vector<GeneratorFigure> figures(const Budget& budget) const override;
    std::vector<GeneratorFact> facts(const Budget& budget) const override;
    /// In three dimensions the path of the last H and the most levels.
    std::optional<Scene> scene(const Budget& budget) const override;

private:
    std::vector<Vector> places(double h, int level, const Budget& budget) const;
};

/// Surfaces have 2^levels squares along an edge, for at most so many levels.
constexpr int most_surface_levels = 13;

struct HeightField;

/// A landscape: a surface, and water up to some height. Its unit is the edge of the land.
class Terrain : public Generator {
public:
    enum class View { map, contours, solid, coast, grid };

    BrownianMotion surface{0.8, 0.3, 8};
    bool exact = false;  // otherwise by displacing the midpoints of squares
    double water = 0.4;  // the share of the land that lies below the water, from 0 to 1
    std::uint64_t seed = 1;
    std::uint64_t lines = 12;  // how many heights have contour lines
    std::vector<View> views{View::map};
    Camera camera{-60, 35};  // of the solid view
    std::optional<std::pair<int, int>>
        levels;  // a figure for each of these, instead of surface.levels

    /// Throws Error on parameters out of range.
    void check() const;
    /// The surface with so many levels.
    HeightField field(int level, const Budget& budget) const;

    std::vector<GeneratorFigure> figures(const Budget& budget) const override;
    /// The coast.
    GeneratorFigure measured_figure(const Budget& budget) const override;
    std::vector<GeneratorFact> facts(const Budget& budget) const override;
    /// The land as squares in the colours of their heights, with the water flat.
    std::optional<Scene> scene(const Budget& budget) const override;
};

// Aggregates and particles.

/// A straight stroke of a figure of many, with the index of its colour.
struct Link {
    Point from, to;
    std::uint32_t colour = 0;
    bool operator==(const Link&) const = default;
};

/// Pictures of one cluster of diffusion-limited aggregation as it grows. Each particle is drawn
/// joined to the one that it came to touch, in the colours of the list from the oldest to the
/// youngest.
class Aggregates : public Generator {
public:
    std::vector<std::uint64_t> particles{10000};  // a figure for each, with the seed
    std::uint64_t seed = 1;
    bool off_lattice = false;             // discs instead of cells of a grid
    std::optional<std::uint64_t> region;  // of the grid; none: particles come from far away
    bool by_steps = false;                // instead of jumps; in a region
    bool stop_at_border = true;           // of the region: not all particles may come then

    static constexpr std::uint64_t most = 100'000'000;

    /// Throws Error on parameters out of range or that do not fit together.
    void check() const;
    /// Particle by particle: from the one touched to its own place. The first is the seed. The last
    /// answer is kept. Throws BoundReached, Interrupted.
    const std::vector<Link>& links(std::uint64_t count, const Budget& budget) const;

    std::vector<GeneratorFigure> figures(const Budget& budget) const override;
    std::vector<GeneratorFact> facts(const Budget& budget) const override;

private:
    std::vector<Link> grown(std::uint64_t count, const Budget& budget) const;

    mutable std::vector<Link> kept_;
    mutable std::uint64_t kept_count_ = 0;
};

/// A number that chance picks: evenly from `mean - spread` to `mean + spread`.
struct Scatter {
    double mean = 0, spread = 0;

    /// The value for a random number.
    ///
    /// Example: Scatter{2, 1}.at(0) < 1.001
    double at(std::uint64_t number) const;
    bool operator==(const Scatter&) const = default;
};

/// What particles of a kind have when they are born, and what becomes of them. Times are frames,
/// velocities lengths a frame, angles degrees, counter-clockwise from +x.
struct ParticleKind {
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    std::string name;
    Scatter speed{1, 0}, angle{90, 0};
    Scatter life{50, 0};
    Scatter size{1, 0};                    // diameter; of fragments, a share of what burst
    Colour born{1, 1, 1}, dying{1, 1, 1};  // the colour runs from one to the other
    double opacity_born = 1, opacity_dying = 1;
    double weight = 1;               // share of the forces that act on it
    double drag = 0;                 // share of the velocity that is lost in a frame
    double inherits = 0;             // share of the velocity of what burst
    std::size_t trail = 0;           // frames for which it leaves a trail
    std::size_t bursts_into = none;  // the kind of its fragments, when its life ends
    Scatter fragments{0, 0};         // how many
    bool operator==(const ParticleKind&) const = default;
};

/// Where particles are born: evenly between two points, `count` in each frame from `first` to
/// `last` that is a multiple of `every` after the first.
struct Emitter {
    std::size_t kind = 0;
    Scatter count{1, 0};
    std::uint64_t first = 0, last = std::numeric_limits<std::uint64_t>::max(), every = 1;
    Point from, to;
    bool operator==(const Emitter&) const = default;
};

/// A system of particles (Reeves, Particle systems, ACM Transactions on Graphics 2, 1983).
struct ParticleSystem {
    std::vector<ParticleKind> kinds;
    std::vector<Emitter> emitters;
    Point force;                   // added to each velocity in each frame: (0, -a) is gravity
    std::optional<double> ground;  // particles do not fall below this height, and bounce:
    double bounce = 0;             // the share of the upward speed that is left
    std::uint64_t seed = 1;

    /// The most particles of all frames up to `frames` that may be alive at once.
    static constexpr std::uint64_t most = 10'000'000;
};

/// Frames of a particle system: a sky, and on it the particles as discs in front of their trails.
class ParticleShow : public Generator {
public:
    ParticleSystem system;
    std::vector<std::uint64_t> shown{0};  // the frames of the picture
    std::uint64_t last_frame = 100;       // of the animation
    Colour sky{1, 1, 1};
    std::optional<Box> view;  // none: around all particles of the frames that are drawn

    static constexpr std::uint64_t most_frames = 100'000;

    /// Throws Error on a system or frames that make no sense.
    void check() const;

    std::vector<GeneratorFigure> figures(const Budget& budget) const override;
    std::vector<GeneratorFigure> frames(const Budget& budget) const override;
    std::vector<GeneratorFact> facts(const Budget& budget) const override;

private:
    std::vector<GeneratorFigure> drawn(const std::vector<std::uint64_t>& wanted,
                                       const Budget& budget) const;
};

// Graphs of functions, and boxes.

/// Weierstrass's function, W(x) = sum over n of a^n cos(b^n pi x): continuous and, for 1/b <= a <
/// 1, without a derivative anywhere (Weierstrass 1872 for odd b and ab > 1 + 3 pi / 2; Hardy 1916).
///
/// Its graph has the box dimension 2 + log a / log b (Kaplan, Mallet-Paret and Yorke 1984), and for
/// whole numbers b this is its Hausdorff dimension (Shen, Mathematische Zeitschrift 289, 2018; for
/// random phases Hunt, Proc. AMS 126, 1998).
class WeierstrassFunction : public Generator {
public:
    double a = 0.5, b = 3;
    std::uint64_t most_terms = 40;     // as many as doubles can tell, where b is large
    std::vector<std::uint64_t> terms;  // a figure for each of these sums; otherwise
    std::uint64_t zooms = 0;           // one of all of it, and of so many parts b times finer each
    double from = 0, to = 2;
    std::size_t points = 4096;  // of a graph

    /// Throws Error unless 0 < a < 1, b > 1 and a b >= 1, terms are 1 to 1000, and from < to.
    void check() const;
    /// The sum of the first `count` terms.
    double sum(double x, std::uint64_t count) const;
    /// 2 + log a / log b.
    double dimension() const;

    std::vector<GeneratorFigure> figures(const Budget& budget) const override;
    GeneratorFigure measured_figure(const Budget& budget) const override;
    std::vector<GeneratorFact> facts(const Budget& budget) const override;
};

/// A set covered with squares of several sizes, as box counting does: the squares of a grid that
/// the set touches, and their number.
class BoxCover : public Generator {
public:
    enum class Shape { segment, square, koch, coast };

    Shape shape = Shape::koch;
    std::vector<double> cells{1, 0.5, 0.25};  // the sides of the squares
    bool turned = false;  // of Koch's curve: three squares to each copy, turned with it
    bool plot = false;    // then one figure: log N(m) against log(1/m), and the line that fits best
    std::uint64_t seed = 1;  // of the coast

    /// Throws Error on sides of 0, above 1 or below 1/4096.
    void check() const;
    /// The set as lines; the square as its outline. Its longest side is 1, its lower left corner
    /// (0, 0).
    std::vector<Stroke> strokes(const Budget& budget) const;
    /// A square by its lower left corner and the way to the next one.
    struct Square {
        Point corner, edge;
    };
    /// The squares of this side that the set touches, each once. A point on the upper or right end
    /// of the whole belongs to the square before it. Turned, 3 * 4^(n-1) of the side 3^-n, as a
    /// copy is lower than a third of its width; Error for other sides.
    std::vector<Square> covering(double side, const Budget& budget) const;

    std::vector<GeneratorFigure> figures(const Budget& budget) const override;
    GeneratorFigure measured_figure(const Budget& budget) const override;
    std::vector<GeneratorFact> facts(const Budget& budget) const override;
};

// The fractals of Pisot substitutions (Rauzy, Nombres algébriques et substitutions, 1982). The prefixes of the infinite word
// of such a substitution stay near a line; seen along it, they fill a compact set, one part of it for each letter that follows
// them. Which of these parts meet is decided exactly, and from it whether they tile, whether they are connected, and the dimension
// of their boundary.

/// Two parts that meet, T_first and T_other moved by the vector.
struct RauzyNeighbour {
    std::size_t first = 0, other = 0;
    std::vector<std::int64_t> vector;

    bool operator==(const RauzyNeighbour&) const = default;
    bool operator<(const RauzyNeighbour& right) const;
};

/// What is decided of the parts T_a of the fractal, one for each letter.
struct RauzyFractal {
    std::vector<Symbol> letters;
    Rate factor = Rate(1);  // by which lengths grow, a Pisot unit
    /// All pairs of parts of the self-replicating tiling that meet, seen from the first, by `first`.
    std::vector<RauzyNeighbour> neighbours;
    /// At which pairs of parts that meet multiply when all parts are divided; 1 where it is boundedly often.
    Rate meeting = Rate(1);
    /// Whether the parts, moved by the self-replicating set of vectors, overlap only in sets of measure 0, and so do the moved
    /// fractals of the periodic tiling; otherwise points lie in several ones.
    bool tiles = false;
    bool parts_connected = false;  // all of them
    bool connected = false;        // the union of the parts

    /// The dimension of the boundary of each part, of boxes and Hausdorff's, where all other conjugates of the factor are
    /// equally large: with two letters, or with three and complex conjugates.
    bool is_similar = false;
    std::string boundary_text() const;
    std::optional<Ball> boundary(long bits) const;
};

/// Throws Error unless the letters that the axiom leads to have a substitution whose matrix has the determinant 1 or -1, an irreducible
/// characteristic polynomial, and one eigenvalue of size 1 or more; BoundReached where there are too many vectors to look at. Any
/// axiom leads to the same parts.
///
/// Example: rauzy_fractal(d0l("a", {{'a', "ab"}, {'b', "a"}})).tiles
RauzyFractal rauzy_fractal(const D0L& system, const Budget& budget = {});

/// The parts of three letters with complex conjugates as an iterated function system: the first state is their union, and its
/// maps, one for each letter, place them. Throws what `rauzy_fractal` throws, and Error for other substitutions.
///
/// Example: rauzy_functions(d0l("a", {{'a', "ab"}, {'b', "ac"}, {'c', "a"}})).states.size() == 4
IteratedFunctions rauzy_functions(const D0L& system, const Budget& budget = {});

/// The fractal as a set of the lattice of the vectors of three letters, which lies densely in the plane, with the periods of its periodic
/// tiling where it has one. Throws what `rauzy_fractal` throws, and Error for another number of letters.
LatticeSet rauzy_lattice_set(const D0L& system, const Budget& budget = {});

/// What is drawn of a fractal in the plane: its parts, or these among their neighbours of one of the two tilings.
enum class RauzyPicture { fractal, periodic, self_replicating };

/// The parts of three letters as polygons, each in the colour of its letter: a part is divided until there are some ten thousand
/// pieces, and each piece is replaced by the parallelogram of the stepped plane that stands for it, of the same area (Arnoux and Ito,
/// Pisot substitutions and Rauzy fractals, 2001). These parallelograms tile, so the polygons neither overlap nor leave gaps. Of the
/// tilings, what lies within so many widths of the fractal; in the periodic one moved copies are paler.
///
/// Throws what `rauzy_fractal` throws, and Error unless there are three letters: the fractal of n lies in n - 1 dimensions.
std::unique_ptr<Figure> rauzy_figure(const D0L& system, RauzyPicture picture,
                                     const Budget& budget = {});

/// The polygons of the parts of the same figure, by letter and not moved.
///
/// Example: rauzy_polygons(d0l("a", {{'a', "ab"}, {'b', "ac"}, {'c', "a"}})).size() == 3
std::vector<std::vector<Point>> rauzy_polygons(const D0L& system, const Budget& budget = {});

}  // namespace algae
