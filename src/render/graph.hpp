#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "render/picture.hpp"
#include "system/settings.hpp"

namespace algae {

/// A graph to be drawn: letters, systems or families of languages, and what joins them. Graphviz
/// places it, Cairo draws it.
struct Graph {
    struct Node {
        enum class Shape {
            round,     // a circle, as much longer as its label needs
            box,       // with rounded corners
            bare,      // its label alone
            triangle,  // its label within the lower half
            start,     // nothing: where an arrow comes from
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
        bool places = true;  // whether it helps to say which node stands above which
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
    std::vector<Key> keys;
    std::string caption;    // underneath
    bool ordered = false;   // each row is in its order, from left to right
    bool trees = false;     // edges make trees, as `tree_layout` places them
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
/// Throws Error on options out of range, if Graphviz cannot place the graph, or if the file cannot
/// be written; what budget.check throws, before and after Graphviz is at work: it cannot be
/// stopped.
GraphDrawn draw_graph(const Graph& graph, const std::string& path, PictureFormat format,
                      const GraphOptions& options = {}, const Budget& budget = {});
GraphDrawn draw_graph(const Graph& graph, std::ostream& stream, PictureFormat format,
                      const GraphOptions& options = {}, const Budget& budget = {});

/// The graph in Graphviz's own language, for `dot` and programs that read it. Nodes are named n0,
/// n1... in the order of `nodes`; nodes of one row stand in a subgraph with rank=same, where the
/// order of rows counts joined by invisible edges.
std::string dot_text(const Graph& graph);

}  // namespace algae
