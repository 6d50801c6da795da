#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "system/system.hpp"
#include "word/word.hpp"

// model: an L-system together with how its file wants it drawn and what the file expects of it. The theory sees the
// rules alone (system.hpp). Of the rooms above, only sources that read or write a setting of the drawing include this
// face; the others say `struct Model;`, so that a new setting leaves them as they are.

namespace algae {

/// That a symbol is a solid or moves the turtle, as a file says it: `solid F box height width`. The
/// first parameter of F is then the height and the second the width.
struct SolidSetting {
    Symbol symbol = 0;
    std::string kind;                   // one of solid_kinds()
    std::vector<std::string> measures;  // what the parameters are, in order

    bool operator==(const SolidSetting&) const = default;
};

/// A kind of solids: its name and its measures. Each name has an older one, by which the notation of
/// parametric systems in VRML knew it: `_typeCube` with `_width`.
struct SolidKind {
    struct Name {
        std::string name, reserved;
    };
    Name name;
    std::vector<Name> measures;
};

/// box, cylinder, cone and sphere, which stand around the turtle, rotation and translation, which
/// turn and move it.
///
/// Example: solid_kinds().front().name.name == "box"
const std::vector<SolidKind>& solid_kinds();

/// The kind of that name, by either of its names; null if there is none.
///
/// Example: solid_kind("_typeCube")->name.name == "box"
/// Example: solid_kind("cube") == nullptr
const SolidKind* solid_kind(std::string_view name);

/// A direction seen from a figure, in degrees: `azimuth` counter-clockwise from +x, seen from above,
/// and `elevation` above the horizon, from -90 to 90.
struct Direction {
    Quantity azimuth, elevation;
    bool operator==(const Direction&) const = default;
};

/// Where a camera stands: `camera -60 15 perspective 40`.
struct CameraSetting {
    Direction from;
    bool perspective = false;
    std::optional<Quantity> opening;  // degrees that the picture spans in perspective, below 180
    bool operator==(const CameraSetting&) const = default;
};

/// Three coordinates: `tropism 0 0 -1`.
struct Triple {
    Quantity x, y, z;
    bool operator==(const Triple&) const = default;
};

/// A surface that a symbol leaves where the turtle stands: `surface K leaf`,
/// `surface K polygon (0,0,0) (1,0,0) (1,1,0)`. Points are along heading, left and up, in steps.
struct SurfaceSetting {
    Symbol symbol = 0;
    std::string kind;            // one of surface_kinds()
    std::vector<Triple> points;  // of a polygon its corners, of a patch its 16 Bezier points

    bool operator==(const SurfaceSetting&) const = default;
};

/// leaf, petal and disc, which are known by name, polygon and patch, which have points.
///
/// Example: surface_kinds().front() == "leaf"
const std::vector<std::string>& surface_kinds();

/// The shapes that a stamp may have.
enum class StampShape : unsigned char { square, circle, triangle };

/// Their names, in this order.
///
/// Example: stamp_shapes().front() == "square"
const std::vector<std::string>& stamp_shapes();

/// How a system wants to be drawn. Whatever a file does not say is absent here and has the value
/// given in the comment.
struct Drawing {
    std::optional<Quantity> angle;   // degrees that + and - turn by; 90
    std::optional<Quantity> step;    // length of F and f in generation 0; 1
    std::optional<Quantity> shrink;  // factor on the step per generation; 1
    struct Start {
        Quantity x, y, heading;  // heading in degrees, 0 along +x, counter-clockwise
        bool upward = false;     // `start upward`: 0 0 90 in the plane, along +z in space
        bool operator==(const Start&) const = default;
    };
    std::optional<Start> start;      // 0 0 0
    std::optional<Quantity> spin;    // degrees added to the start heading per generation; 0
    std::optional<Quantity> scale;   // factor of the symbol * on the turtle's own step; * ignored
    std::optional<Quantity> narrow;  // factor of the symbol ! on the line width; ! ignored
    std::optional<Quantity> width;   // line width, in points of the picture; 1
    bool clockwise = false;          // `turn clockwise`: + turns right
    std::vector<Symbol> plotters;    // `plot F`: F(x,y) draws a line to the point (x,y)
    struct Stamp {
        Symbol symbol = 0;
        StampShape shape = StampShape::square;
        bool operator==(const Stamp&) const = default;
    };
    std::vector<Stamp> stamps;         // `stamp S square`: S leaves a filled shape where it stands
    std::vector<SolidSetting> solids;  // `solid F box width`: F is a box, its parameter the width
    std::vector<SurfaceSetting> surfaces;  // `surface K leaf`: K leaves a surface
    std::optional<Triple> tropism;  // direction that steps bend to, as strong as it is long; none
    bool bends_before = false;      // before steps and moves, not after strokes
    std::optional<Quantity> susceptibility;  // factor on how far they bend; 1
    std::vector<Symbol>
        elastic;  // `elasticity T`: T(e) makes the factor e, T(m,a) m times what it was and a
    std::optional<CameraSetting> camera;  // of figures in space; -60 15
    std::optional<Direction> light;       // where it comes from; over the camera's left shoulder
    std::optional<Quantity> fog;          // share that the farthest part takes of the background; 0
    std::vector<std::string> colours;  // `colour`: names or #rrggbb, the first for the start, the
                                       // symbol ' goes on to the next; or one of colour_schemes()
    std::optional<std::pair<std::uint64_t, std::uint64_t>> generations;  // `generation 0..6`
    std::optional<std::pair<std::uint64_t, std::uint64_t>> seeds;        // `seed 1..3`; 1
    std::optional<std::uint64_t> columns;  // `columns 3`: panels in a row; as many as suit
    std::optional<bool> common_scale;      // `common-scale yes`: of panels; where it suits
    std::string picture;                   // `picture tree`: one of picture_kinds(); figure
    /// A text at a point: `label 0 1 B`, in space `label (0, 0, 2) top`.
    struct Label {
        Triple place;           // z is 0 where the file gives two coordinates
        bool in_space = false;  // whether it gives three
        std::string text;
        bool operator==(const Label&) const = default;
    };
    std::vector<Label> labels;

    bool operator==(const Drawing&) const = default;
};

/// What a file says must come out: `expect length 3: 148`. The value is kept as written.
struct Expectation {
    std::string kind;  // one of expectation_kinds()
    std::uint64_t generation = 0;
    std::string value;
    Place place;

    bool operator==(const Expectation& other) const {
        return kind == other.kind && generation == other.generation && value == other.value;
    }
};

/// What the picture of a file may be: `figure`, what the turtle draws; `table`, its commands one by one; `tree`, the derivation
/// tree of a generation; `plot`, the lengths of generations.
///
/// Example: picture_kinds().front() == "figure"
const std::vector<std::string>& picture_kinds();

/// What a file may expect of a generation.
///
/// Example: expectation_kinds().front() == "length"
const std::vector<std::string>& expectation_kinds();

/// `coding { a -> 0; b -> 1 }`: the letters that stand for letters of the system where words are shown. A letter without
/// an image stands for itself. The language of the system, its growth and its figures are those without the coding.
struct Coding {
    std::vector<std::pair<Symbol, std::string>> images;  // each the name of one letter

    bool empty() const { return images.empty(); }
    bool operator==(const Coding&) const = default;
};

/// A coding as a morphism from the letters of a system into an alphabet of its own.
struct LetterCoding {
    /// Every letter of the alphabet has an image.
    LetterCoding(const Alphabet& letters, const Coding& coding);

    Alphabet alphabet;
    Morphism morphism;
};

/// What a `.lsys` file says: an L-system, how it is drawn, and what is expected of it. Theory takes it as the LSystem
/// that it is, and nothing of the rules is said twice: `as_d0l(model)`, `model.rules`.
struct Model : LSystem {
    Drawing drawing;
    std::vector<Expectation> expectations;
    Coding coding;

    bool operator==(const Model& other) const;  // all but names and places of origin
};

/// Whether a plant of this system lies on its side unless something is done about it: the words have branches, the
/// axiom does not turn, and nothing says where the turtle starts.
bool lies_down(const Model& model);

}  // namespace algae
