#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "render/render.hpp"
#include "turtle/turtle.hpp"
#include "word/word.hpp"

typedef struct _cairo cairo_t;

namespace algae {

/// The font of texts in graphs: DejaVu Sans, or the substitute of the machine.
struct GraphFont {
    double size = 12;
    bool bold = false;
};

/// The width of a text with a subscript in points. It does not depend on pixels, so it is the same for
/// all formats.
double text_width(const std::string& text, const std::string& subscript, const GraphFont& font);

/// Writes a text with a subscript; `x` is its middle (share 0.5), its left (0) or its right end
/// (1), `y` the middle of a capital letter.
void write_text(cairo_t* context, const std::string& text, const std::string& subscript,
                const GraphFont& font, double x, double y, double share = 0.5);

/// Sizes of texts in graphs, in points.
inline constexpr double graph_letters = 12;       // of labels of nodes
inline constexpr double graph_small_letters = 9;  // of all other texts

/// Where everything of a graph stands, in points, from the upper left corner.
struct GraphLayout {
    struct Line {
        std::vector<Point> points;  // a start, then three points for each Bezier curve
        std::optional<Point> tip;   // of the arrow, which begins at the last point
        Point label;
    };
    struct Frame {
        double left = 0, top = 0, right = 0, bottom = 0;
        Point label;
    };
    double width = 0, height = 0;
    std::vector<Point> nodes;  // their middles
    std::vector<Line> edges;
    std::vector<Frame> groups;
};

/// The width and height of a node, so that its label fits.
Point node_size(const Graph::Node& node);

/// Places a graph by Graphviz's `dot` (Gansner, Koutsofios, North and Vo 1993), which looks for few crossings
/// and short edges. A process places one graph at a time, because Graphviz has global state.
/// Throws Error with Graphviz's own words if it fails, and what budget.check throws, before
/// and after.
GraphLayout graph_layout(const Graph& graph, const Budget& budget = {});

/// Places a graph whose edges make trees, a row a generation: leaves stand side by side at equal
/// distances in their order, a letter over the middle between its first and its last child, the
/// trees one beside the other. (Graphviz puts a letter with two children over one of them.) Linear
/// time.
GraphLayout tree_layout(const Graph& graph, const Budget& budget = {});

/// A graph that is placed: the size of its page in points, and what draws it there.
struct GraphPicture {
    double width = 0, height = 0;
    std::function<void(cairo_t*)> draw;
};
GraphPicture graph_picture(const Graph& graph, const Budget& budget);

/// How many units of the picture a point of the page is. Throws Error if options are out of range.
double graph_scale(const GraphDrawn& page, PictureFormat format, const GraphOptions& options);
/// The size of the picture of a page.
GraphDrawn graph_page(const GraphDrawn& page, double scale, PictureFormat format);

/// A node with a letter's name, its subscript lowered.
///
/// Example: letter_node(*d0l("a", {}).alphabet, 0).label == "a"
Graph::Node letter_node(const Alphabet& alphabet, Symbol letter);

}  // namespace algae
