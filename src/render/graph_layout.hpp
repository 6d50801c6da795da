#pragma once

#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "render/graph.hpp"
#include "turtle/canvas.hpp"

namespace algae {

/// Sizes of what graphs are made of, in points.
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

/// Places a graph by Graphviz's `dot` (Gansner, Koutsofios, North and Vo 1993): as few crossings
/// and as short edges as it finds. One at a time in a process, since Graphviz has global state.
/// Throws Error with Graphviz's own words if it cannot, and what budget.check throws, before it
/// begins and after.
GraphLayout graph_layout(const Graph& graph, const Budget& budget = {});

}  // namespace algae
