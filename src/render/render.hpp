#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
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

// render: figures, graphs and scenes as files. Pictures and pages by Cairo (svg, pdf, png, ps, eps), figures as text (tex, typ,
// csv, geojson, dxf, html, svg, abc, mid), animations (gif, webp), pages that explain a turtle, plots, graphs placed by Graphviz, and meshes of
// figures in space. No other room uses these formats and libraries.
//
// A file appears whole or not at all, and equal figures make equal files, byte for byte. Functions draw to a Target: the path of a
// file or a stream, such as standard output. Read in this order: files; pictures; animations; explanations; pages of
// pictures; plots; graphs; meshes; images that are read.

namespace algae {

struct DerivationTree;

/// Where the bytes of a document go.
class Output {
public:
    virtual ~Output() = default;
    /// Throws Error if the bytes cannot be written, with the system's reason.
    virtual void write(const char* bytes, std::size_t count) = 0;
};

/// A file that appears whole or not at all: its bytes go to a temporary file in the same folder
/// until `commit` gives it its name. If the path is not an ordinary file (a pipe, /dev/stdout), it is written
/// directly; a symbolic link is followed.
class FileOutput final : public Output {
public:
    /// Throws Error if `path` is a directory, is kept (see below) or cannot be written. `is_input`: a file that is kept as an
    /// input may be replaced.
    explicit FileOutput(const std::string& path, bool is_input = false);
    FileOutput(const FileOutput&) = delete;
    FileOutput& operator=(const FileOutput&) = delete;
    /// Without `commit`, no file is left behind, and a file of that name is unchanged.
    ~FileOutput() override;

    void write(const char* bytes, std::size_t count) override;
    /// Throws Error if the file cannot be completed.
    void commit();

private:
    [[noreturn]] void fail(int reason) const;
    void flush();

    std::string path_;       // as the caller wrote it, for messages
    std::string target_;     // where symbolic links lead
    std::string temporary_;  // empty if written directly
    std::string buffer_;
    int descriptor_ = -1;
};

/// From now on no FileOutput replaces this file, by whatever name: the program has read it. A path that is not an ordinary file is
/// left out.
void keep_input(const std::string& path);

/// From now on no FileOutput replaces any file that is there.
void keep_all_files();

/// Removes the temporary files of all FileOutputs; may be called from a handler of signals, just before the program ends.
void remove_unfinished_files() noexcept;

/// Where a drawing goes: to a file, given by its path, or to a stream, which must outlive this. Functions take
/// either in its place.
struct Target {
    Target(const char* file) : path(file) {}
    Target(std::string file) : path(std::move(file)) {}
    Target(std::ostream& out) : stream(&out) {}

    std::string path;
    std::ostream* stream = nullptr;  // if set, there is no file
};

enum class PictureFormat { svg, pdf, png, ps, eps };

/// The picture format that the extension of a file name stands for, in any case.
///
/// Throws Error, which lists the formats, if the extension is not one of a picture.
///
/// Example: picture_format("figures/koch.SVG") == PictureFormat::svg
PictureFormat picture_format(std::string_view path);

/// The name of the format, which is the extension of its files.
///
/// Example: format_name(PictureFormat::svg) == std::string("svg")
const char* format_name(PictureFormat format);

/// A text at a point of a figure, in the units of the file.
struct PointLabel {
    std::string text;
    Vector place;
};

/// How a picture is made. Lengths are points (1/72 inch) in svg, pdf, ps and eps, pixels in png.
struct PictureOptions {
    /// The size of the whole picture. If one of the two is given, the other follows from the figure; if
    /// neither is given, the longer side is 600 points or 1000 pixels.
    std::optional<double> width, height;
    /// The blank border; at least half a line width is used, so that no stroke is cut off.
    double margin = 10;
    /// Instead of the figure's own `width`, or of 1 (0.6 points in a row of panels). These two hold for
    /// pictures up to the default size, and grow with larger ones; where strokes of the latter would
    /// cover more than half of the box of a figure, it is thinner, down to 0.4 of it.
    std::optional<double> line_width;
    /// Instead of the figure's own `colour`: names, `#rrggbb` or `along`.
    std::vector<std::string> colours;
    /// A colour or `transparent`. By default white in png, no background in other formats.
    std::optional<std::string> background;
    /// The height of the letters of captions. By default 1/50 of the picture's longer side, down to
    /// 1/80 if panels share a row.
    std::optional<double> font_size;
    /// Pages and panels: one scale for all, as large as the largest figure allows, and all figures
    /// standing on one line.
    bool common_scale = false;
    /// Panels: how many in a row. By default up to 5 in one row, then rows of equal length.
    std::optional<std::size_t> columns;
    /// A bar below the figure that shows a round length in the units of the file.
    bool scale_bar = false;
    std::vector<PointLabel> labels;
    /// Strokes end flat at their ends instead of round.
    bool flat_ends = false;
    /// What the file says of itself: in pdf, and in figures as text. May be empty.
    std::string title, source, author;

    enum class Route {
        automatic,  // strokes; cells where segments are finer than the picture can show
        strokes,    // every stroke by Cairo
        cells,      // cells in png, an image in the other formats
    };
    Route route = Route::automatic;
    /// A vector format has at most this many strokes; a figure with more is embedded as an image
    /// of 4 pixels a point.
    std::uint64_t most_strokes = 5'000'000;
};

/// A figure of a picture, its name in messages ("generation 3 of koch.lsys"), and the text
/// written underneath.
struct Plate {
    const Figure* figure = nullptr;
    std::string name;
    std::string caption;
};

/// What was drawn.
struct Drawn {
    double width = 0, height = 0;  // of the picture or of each page
    std::uint64_t lines = 0;       // lines and polygons drawn, after parts were joined
    std::uint64_t polygons = 0;
    bool as_image = false;           // a vector format with an image in it
    bool fine = false;               // some segments were finer than the picture can show
    std::vector<std::size_t> blank;  // plates in which nothing is drawn
};

/// Writes the picture of one figure. A file appears complete or not at all, and equal
/// figures make equal files, byte for byte.
///
/// Throws Error if options are out of range, a colour is unknown, a figure has no strokes, or the file
/// cannot be written; BoundReached if the picture needs more memory than the budget has, or
/// after its deadline; Interrupted. One pass over the figure: O(strokes) time; if strokes are finer
/// than the picture can show, O(pixels) time and memory.
Drawn draw_picture(const Plate& plate, const Target& target, PictureFormat format,
                   const PictureOptions& options, const Budget& budget,
                   Progress* progress = nullptr);

/// One page for each figure, all pages of one size. Only pdf and ps have pages; other formats throw Error. The page of
/// a figure without strokes is blank; if no figure has strokes, Error.
Drawn draw_pages(std::span<const Plate> plates, const Target& target, PictureFormat format,
                 const PictureOptions& options, const Budget& budget, Progress* progress = nullptr);

/// All figures side by side, in one row or several, each scaled to fill its cell.
Drawn draw_panels(std::span<const Plate> plates, const Target& target, PictureFormat format,
                  const PictureOptions& options, const Budget& budget,
                  Progress* progress = nullptr);

/// Formats that hold figures in the plane as text, to be edited, set in a document or computed with.
enum class FigureFormat {
    tex,      // TikZ
    typ,      // Typst
    csv,      // a row for each stroke
    geojson,  // a feature for each path
    dxf,      // AutoCAD, release 12
    html,     // a page that shows them, and how they come to be
    abc,      // a score: a way to the side is time, height is pitch
    mid,      // the same to be heard, MIDI
    svg,      // with a group for each colour; `draw_picture` writes svg by Cairo
};

/// The format that the extension of a file name stands for, in any case; nothing for other extensions and for svg.
///
/// Example: figure_format("koch.TEX") == FigureFormat::tex
/// Example: !figure_format("koch.svg")
std::optional<FigureFormat> figure_format(std::string_view path);

/// The name of the format, which is the extension of its files.
///
/// Example: figure_format_name(FigureFormat::geojson) == std::string("geojson")
const char* figure_format_name(FigureFormat format);

/// A figure in the plane with what is known of it beyond its strokes.
struct FigureSource {
    Plate plate;
    std::uint64_t generation = 0;
    std::uint64_t modules = 0;  // of the word; 0 if there is none
    /// The letter of the word at this position; empty if it is not known. It outlives the call.
    std::function<std::string_view(std::uint64_t)> letter = {};
    /// The same figure with exact points, as `outline` gives it, and its start where that is rational; may be missing.
    std::shared_ptr<const Outline> outline = nullptr;
    std::optional<std::pair<Rational, Rational>> start = {};
};

/// How figures are written as text.
struct FigureTextOptions {
    /// Sizes, colours and captions, as far as the format has them.
    PictureOptions picture;
    /// For a plotter: each segment once, joined to as few paths as possible, with short ways between them, a layer for
    /// each colour.
    bool plotter = false;
    bool panels = false;  // several figures side by side, where the format has room for it
};

/// Whether a figure as text says which letters draw its strokes: where it does not, `letter` is never called. svg of 100,000 strokes and
/// more does not, unless it is for a plotter.
bool names_letters(const Figure& figure, FigureFormat format, bool plotter);

/// What was written.
struct FigureTextDrawn {
    double width = 0, height = 0;  // in points; 0 where the format has the units of the figure
    std::uint64_t strokes = 0;     // straight ones
    std::uint64_t paths = 0;       // each in one go
    std::uint64_t polygons = 0;
    std::uint64_t repeated = 0;  // strokes left out for a plotter, because they were there already
    double travel = 0,
           travelled = 0;     // the way with the pen up: as written, and in the order of the word
    bool exact = false;       // whether exact coordinates stand beside the decimals
    std::uint64_t notes = 0;  // of music
    std::vector<std::size_t> blank;  // figures in which nothing is drawn
};

/// Writes figures as text, in the order of their words or, for a plotter, in the order of a short way. A file
/// appears complete or not at all, and equal figures make equal files. tex, typ and svg are laid out as pictures
/// are; html shows one figure at a time; csv, geojson and dxf have the units of the figures; abc and mid are music (Prusinkiewicz 1986),
/// a voice for each figure: the usual stroke to the side is an eighth, and as far up a degree of C major.
///
/// Throws what draw_panels throws, BoundReached if the paths take more memory than the budget has, and Error for music without a
/// stroke to the side.
FigureTextDrawn draw_as_text(std::span<const FigureSource> figures, const Target& target,
                             FigureFormat format, const FigureTextOptions& options,
                             const Budget& budget, Progress* progress = nullptr);

enum class AnimationFormat {
    gif,
    webp,
    mp4,   // H.264, by the program ffmpeg
    webm,  // VP9, likewise
};

/// The animation format that the extension of a file name stands for, in any case; nothing for other extensions.
///
/// Example: animation_format("plant.GIF") == AnimationFormat::gif
std::optional<AnimationFormat> animation_format(std::string_view path);

/// The timing of an animation.
struct AnimationTiming {
    double frame = 0.8;  // seconds, from 0.02 to 600, in hundredths
    /// The last frame. By default three times as long as the others, at least 2 seconds.
    std::optional<double> last;
    std::uint32_t plays = 0;  // how often it is shown, below 65,536; 0: for ever
};

/// An animation of figures, one frame for each, all of one size in pixels; sizes are as in png. A frame
/// shows its figure as large as possible; with the option common_scale all frames show the same part of the
/// plane, so that figures grow in place. Files appear complete or not at all, and equal figures make equal
/// files. A webp has exactly the pixels of a png; a gif does too if all frames together have at most
/// 256 colours, otherwise it has the 256 most similar ones. An mp4 and a webm are videos, which the program ffmpeg packs: their sides
/// are even, they are played once or as often as the player likes, and their bytes are those of that version of ffmpeg.
///
/// Throws Error if options are out of range, if a gif or a video has a transparent background, if no figure draws anything,
/// if a video is asked for and there is no ffmpeg or it fails, or if the file cannot be written; BoundReached if the frames take more memory than the budget has,
/// or after its deadline; Interrupted. O(strokes + frames * pixels) time.
Drawn draw_animation(std::span<const Plate> plates, const Target& target, AnimationFormat format,
                     const PictureOptions& options, const AnimationTiming& timing,
                     const Budget& budget, Progress* progress = nullptr);

/// The explanation of a word with more symbols does not fit a page.
inline constexpr std::size_t longest_explanation = 60;

/// A page that explains a turtle to students: its way with a number for each step, the
/// turtle at every corner, as it comes (pale) and as it leaves, and a table of the steps beside or
/// below. The turtle stays in the plane. Only the options width, height, colours and background
/// are used; the page is as large as its text needs, scaled to the given width or height.
///
/// Throws Error if the word has more symbols than longest_explanation or leaves the plane, if options
/// are out of range, or if the file cannot be written.
void draw_explanation(const Explanation& explanation, const std::string& title,
                      const Target& target, PictureFormat format, const PictureOptions& options,
                      const Budget& budget = {});

/// The steps of an explanation as rows of text: the head, the turtle at its start, then one row for each step.
/// Columns without information are left out.
///
/// Example: explanation_rows(Explanation{}).size() == 2
std::vector<std::vector<std::string>> explanation_rows(const Explanation& explanation);

/// One picture of a page. Paths are relative to the page.
struct PagePicture {
    std::string group;          // pictures of a group stand together, under its name; may be empty
    std::string name;           // what the figure is called
    std::string title, source;  // may be empty
    std::string preview;        // a small picture that browsers show; empty if there is none
    std::vector<std::string> files;     // the picture in its formats
    std::string text;                   // of the file that it is made from
    std::vector<std::string> problems;  // what is wrong with it
};

/// A page of pictures as HTML that needs only the pictures: groups in their order with a list
/// of them at the top; under each picture its title, its source, links to its files, its problems
/// and, folded, the text that it is made from.
///
/// Example: picture_page("Figures", {}).starts_with("<!DOCTYPE html>")
std::string picture_page(const std::string& title, const std::vector<PagePicture>& pictures);

/// A diagram of one sequence: dots, and a line through the values of a formula.
struct Plot {
    std::string caption;     // underneath
    std::string formula;     // beside the line; may be empty
    std::string horizontal;  // what the axes show
    std::string vertical;
    bool logarithmic = false;  // then all heights are decimal logarithms
    std::vector<std::pair<double, double>> dots;
    std::vector<std::pair<double, double>> line;
};

/// Draws it in the format of the path's extension, 480 x 320 points (png: 960 x 640 pixels).
/// Throws Error if there is nothing to draw or the file cannot be written.
void draw_plot(const Plot& plot, const std::string& path, const Budget& budget = {});

/// Length against generation, from `first` to `last`: dots are exact lengths, the line is the closed
/// form; logarithmic if the growth is exponential.
Plot growth_plot(const D0L& system, std::uint64_t first, std::uint64_t last,
                 const Budget& budget = {});

/// A log-log plot of box counts.
struct DimensionPlot {
    std::string caption;  // underneath
    BoxCounts counts;
    BoxFit fit;
    /// What is known of the dimension by other means: beside the estimate, and as the slope of a line.
    std::optional<double> exact = std::nullopt;
    std::string exact_text = {};  // "log 4 / log 3"
};

/// Draws, in the format of the path's extension, the number of cells against how many of them
/// lie side by side, both logarithmic: the mean over the grids' offsets with its range, a straight line of the estimated
/// slope through the scales used, which are shaded, and underneath the deviation of each mean from that line in per cent.
/// Scales left out because cells are too large, or too small, have marks of their own.
/// 480 x 420 points (png: 960 x 840 pixels).
///
/// Throws Error if there are fewer than two scales or the file cannot be written.
void draw_dimension_plot(const DimensionPlot& plot, const std::string& path,
                         const Budget& budget = {});

/// A log-log plot of another measure, such as Richardson's plot of lengths measured with dividers.
struct ScalingPlot {
    std::string caption;       // underneath
    std::string value, scale;  // what is measured, and what the sizes are: "length", "opening"
    Scaling scaling;
};

/// Draws the values against the coarsest size divided by each size, both logarithmic, in the same way;
/// the line is the least-squares line through the scales used.
///
/// Throws Error if there are fewer than two scales, if a value is not above 0, or if the file cannot
/// be written.
void draw_scaling_plot(const ScalingPlot& plot, const std::string& path, const Budget& budget = {});

/// A graph to be drawn: letters, systems or families of languages, and their relations. Graphviz
/// places it, Cairo draws it.
struct Graph {
    struct Node {
        enum class Shape {
            round,     // a circle, as much longer as its label needs
            box,       // with rounded corners
            bare,      // only its label
            triangle,  // its label within the lower half
            start,     // invisible: the start of an arrow
        };
        std::string label, subscript;
        Shape shape = Shape::round;
        std::optional<Colour> fill;
        bool bold = false;
        bool operator==(const Node&) const = default;
    };
    struct Edge {
        std::size_t from = 0, to = 0;
        std::string label;
        bool arrow = false;
        bool dashed = false;
        bool places = true;  // whether it influences which node stands above which
        bool thin = false;   // a thin arc beside the others; it influences no place
        bool operator==(const Edge&) const = default;
    };
    /// Nodes in a frame.
    struct Group {
        std::string label;
        Colour fill;
        std::vector<std::size_t> nodes;
        bool operator==(const Group&) const = default;
    };
    /// A colour explained underneath.
    struct Key {
        Colour fill;
        std::string text;
        bool operator==(const Key&) const = default;
    };

    std::vector<Node> nodes;
    std::vector<Edge> edges;
    std::vector<Group> groups;
    std::vector<std::vector<std::size_t>> rows;  // nodes on one height
    std::vector<std::string> row_labels;         // beside the rows; may be empty
    std::vector<std::string> step_labels;        // between a row and the next; may be empty
    std::vector<Key> keys;
    std::string caption;    // underneath
    bool ordered = false;   // each row is in its order, from left to right
    bool trees = false;     // edges make trees, a row a generation
    bool upward = false;    // edges lead upward
    bool straight = false;  // edges are straight
    bool operator==(const Graph&) const = default;
};

/// How a graph is drawn. Lengths are points, pixels in png.
struct GraphOptions {
    std::optional<double> width, height;    // of the whole picture, which keeps its proportions
    std::optional<std::string> background;  // as in PictureOptions
};

/// The size of the picture that was drawn.
struct GraphDrawn {
    double width = 0, height = 0;
};

/// Draws the graph in a format. Letters are 12 points high (png: 24 pixels) unless the options or
/// the format's largest size ask for smaller ones. The file appears complete or not at all, and
/// equal graphs make equal files on one machine.
///
/// Throws Error if options are out of range, if Graphviz cannot place the graph, or if the file cannot
/// be written; also what budget.check throws, before and after Graphviz works, which cannot be
/// stopped.
GraphDrawn draw_graph(const Graph& graph, const Target& target, PictureFormat format,
                      const GraphOptions& options = {}, const Budget& budget = {});

/// An animation of graphs, one frame for each, in the middle of a picture in which all have room; otherwise as that of figures.
///
/// Throws Error if there is no graph, and as `draw_graph` and `draw_animation` of figures.
GraphDrawn draw_animation(std::span<const Graph> graphs, const Target& target,
                          AnimationFormat format, const GraphOptions& options,
                          const AnimationTiming& timing, const Budget& budget = {});

/// The graph in Graphviz's own language, for `dot` and programs that read it. Nodes are named n0,
/// n1... in the order of `nodes`; nodes of one row stand in a subgraph with rank=same, where the
/// order of rows counts joined by invisible edges.
std::string dot_text(const Graph& graph);

/// The graph for LaTeX: a tree whose rows are generations in the language of the package `forest`, every other graph as TikZ
/// with each node at its place, in styles that stand at the head. Labels are set as mathematics.
///
/// Throws Error if Graphviz cannot place the graph, and what budget.check throws.
std::string latex_text(const Graph& graph, const Budget& budget = {});

/// A text for LaTeX outside of mathematics.
///
/// Example: escaped_latex("50% of F_l") == "50\\% of F\\_l"
std::string escaped_latex(std::string_view text);

/// The name of a letter or module, or a word, as mathematics, without dollar signs.
///
/// Example: letter_latex("F_l") == "F_{l}"
/// Example: letter_latex("wall") == "\\mathit{wall}"
std::string letter_latex(std::string_view name);

/// The growth digraph of a D0L system: an edge from a letter to each letter of its successor, with
/// how often it occurs there if more than once; arrows without a start lead to the letters of
/// the axiom. Colours show the four fates of a letter, which its strongly connected component decides
/// (Rozenberg and Salomaa 1980, I.3): mortal letters vanish; letters that are not on a cycle pass; the
/// letters of a cycle return once a round; in an expanding component letters multiply by its rate in each
/// step. Components of the last kind, and cycles of several letters, have a frame.
///
/// Takes what `components` takes. Throws what budget.check throws.
///
/// Example: growth_graph(d0l("b", {{'a', "ab"}, {'b', "a"}})).groups[0].label == "rate (1+√5)/2 = 1.6180..."
Graph growth_graph(const D0L& system, const Budget& budget = {});

/// The Rauzy graphs of a language (Rauzy 1983), each by its factors of n + 1 letters for some n: nodes are those of n letters, and each factor is an
/// edge from its beginning to its end that has its last letter. Colours show which factors several letters prolong on the left, on the
/// right, or on both sides. If it is `reduced`, only these are nodes, and edges are the ways between them. Several graphs have a frame each.
///
/// O(size of the factors, times a logarithm).
///
/// Example: rauzy_graph({{{0, 0}, {0, 1}, {1, 0}}}, *d0l("a", {{'a', "ab"}, {'b', "a"}}).alphabet, false).edges.size() == 3
Graph rauzy_graph(const std::vector<std::vector<Word>>& factors, const Alphabet& alphabet,
                  bool reduced);

/// The picture of a derivation tree: one row for each generation, every row in word order, so that the
/// last row reads as the word. Letters that are rewritten have a colour each if there are few of
/// them; letters that stay as they are have no frame, erased letters end in ε, and a triangle stands for
/// a part that is cut off, with the number of letters that it derives. Modules have their parameters beside them, and thin
/// arcs lead to a letter from the contexts that its rule looked at. If subtrees are shared (several edges
/// lead to a letter), an edge says how often the letter below occurs in the
/// successor.
///
/// Example: tree_graph(derivation_tree(d0l("b", {{'a', "ab"}, {'b', "a"}}), 3)).rows.size() == 4
Graph tree_graph(const DerivationTree& tree);

/// Proper inclusions of families of languages: the first is a proper part of the second. Inclusions
/// that follow from others are left out. Languages are compared up to the empty word if a
/// family of Chomsky takes part (Rozenberg and Salomaa 1980; ET0L in CS: van Leeuwen 1975; that
/// regular languages are IL: theory/document-001/families-regular-with-context.claim).
const std::vector<std::pair<const char*, const char*>>& family_inclusions();

/// The diagram of these families: a line leads up to the larger family; dashed lines join 0L with
/// REG and CF, which neither contain it nor are contained in it.
///
/// Example: families_graph().nodes.size() == 14
Graph families_graph();

/// File formats of figures in space for other programs.
enum class MeshFormat {
    glb,    // glTF 2.0, binary
    obj,    // Wavefront, with a file of materials beside
    ply,    // Stanford, binary
    stl,    // binary
    x3d,    // X3D 3.3 as XML
    wrl,    // VRML97
    vrml1,  // VRML 1.0
    pov,    // a scene for POV-Ray 3.7, with light, shadows and a camera
};

/// The mesh format that the extension of a file name stands for, in any case; nothing for other extensions.
///
/// Example: mesh_format("trees/honda.GLB") == MeshFormat::glb
/// Example: !mesh_format("koch.svg")
std::optional<MeshFormat> mesh_format(std::string_view path);

/// The name of the format, which is also the extension of its files, except for `vrml1`.
///
/// Example: mesh_format_name(MeshFormat::wrl) == std::string("wrl")
const char* mesh_format_name(MeshFormat format);

/// The names of all: "glb, obj, ply, stl, x3d, wrl, vrml1 or pov".
std::string mesh_format_names();

/// How a scene is written.
struct MeshChoices {
    MeshOptions mesh;
    /// Instead of the scene's own list: names or `#rrggbb`. If both are empty, everything is gray.
    std::vector<std::string> colours;
    /// The first viewpoint of x3d, wrl, vrml1 and pov, always in perspective.
    Camera camera;
    /// Of pov; none: over the camera's left shoulder.
    std::optional<Light> light;
    /// Behind the scene in x3d, wrl, vrml1 and pov; white by default.
    std::optional<std::string> background;
};

/// What was written.
struct MeshDrawn {
    std::uint64_t vertices = 0;  // corners of triangles, several at a point where there is an edge
    std::uint64_t triangles = 0;
    std::uint64_t solids = 0;  // boxes, cylinders, cones and spheres as such
    std::uint64_t lines = 0;   // strokes without thickness as such
    SpaceBox box;              // in the units of the figure, with the thickness of its rods
};

/// Writes a scene. A file appears complete or not at all, and equal scenes make equal files,
/// byte for byte. An obj comes with a file of materials beside it, of the same name but `.mtl`; in a stream it
/// has no materials.
///
/// A unit of the figure is a unit of the file (in glb a metre). In ply and stl z is up. In glb, obj, x3d,
/// wrl, vrml1 and pov y is up: there (x, y, z) becomes (x, z, -y), so that a tree stands upright. A figure
/// of the plane keeps x and y and faces the reader. In glb and obj each colour is a material, in ply
/// vertices have colours, stl has no colours. x3d, wrl, vrml1 and pov contain a scene graph, in which
/// solids stay solids. What POV-Ray renders of a pov stands on a ground of the colour of the background, in soft shadows; the
/// file says how both are left out.
///
/// Throws what mesh_of throws, Error if a colour is unknown or the file cannot be written,
/// BoundReached if writing takes more memory than the budget has; then no file appears.
MeshDrawn draw_mesh(const Scene& scene, const Target& target, MeshFormat format,
                    const MeshChoices& choices, const Budget& budget);

/// A scene of a page, and what it is called there.
struct NamedScene {
    const Scene* scene = nullptr;
    std::string name;
};

/// Writes scenes as a page of HTML that needs nothing else: the mouse or the fingers turn and move a scene and zoom, and sliders step through the
/// scenes, and through the parts of one in the order in which the turtle left them. Colours, background, camera and the number of facets of
/// round things are those of the choices; of the options only title, source and author are used.
///
/// Throws Error if nothing is drawn, a colour is unknown, or the file cannot be written; BoundReached if it takes more memory than the
/// budget has. O(parts) time.
MeshDrawn draw_scene_page(std::span<const NamedScene> scenes, const Target& target,
                          const MeshChoices& choices, const PictureOptions& options,
                          const Budget& budget);

/// Which pixels of an image are ink, and which are paper.
struct InkOptions {
    /// A pixel is ink if it is darker than this, from 0 (black) to 1 (white); transparent pixels lie
    /// on a white sheet.
    double threshold = 0.5;
    /// Lighter pixels are ink instead.
    bool invert = false;
};

/// Whether the bytes begin like a PNG image.
bool is_png(std::string_view bytes);

/// The pixels of a PNG image that are ink, as points a pixel apart, x to the right and y upward.
///
/// Throws Error if Cairo cannot read the bytes as an image, if the threshold is not between 0 and
/// 1, or if all pixels are ink or all are paper; BoundReached.
PointSet ink_of(std::string_view png, const std::string& name, const InkOptions& options,
                const Budget& budget);

}  // namespace algae
