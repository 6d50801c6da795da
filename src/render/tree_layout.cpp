#include "render/tree_layout.hpp"

#include <algorithm>
#include <cmath>

namespace algae {

namespace {

constexpr double gap = 8;  // between two leaves
constexpr double least_row = 40, largest_row = 80;
constexpr double least_slope = 0.2;  // of the flattest edge, as long as rows do not get too high

/// Where an edge leaves a node of this size: on the circle or pill around it.
Point edge_end(const Point& from, const Point& to, const Graph::Node& node) {
    const Point size = node_size(node);
    const double radius = size.y / 2, arm = std::max(0.0, size.x / 2 - radius);
    const double x = to.x - from.x, y = to.y - from.y, length = std::hypot(x, y);
    if (length == 0) return from;
    if (node.shape == Graph::Node::Shape::triangle) return {from.x, from.y - size.y / 2};
    // The edge leads from row to row, so it is steep enough to leave a pill through its straight
    // side, or through the arc at the end of it.
    const double across = std::clamp(x / std::fabs(y) * radius, -arm, arm);
    const double rest = std::hypot(x - across, y);
    return {from.x + across + (x - across) / rest * radius, from.y + y / rest * radius};
}

}  // namespace

GraphLayout tree_layout(const Graph& graph, const Budget& budget) {
    const std::size_t count = graph.nodes.size();
    std::vector<std::vector<std::size_t>> children(count);
    std::vector<char> is_child(count, 0);
    for (const Graph::Edge& edge : graph.edges) {
        children[edge.from].push_back(edge.to);
        is_child[edge.to] = 1;
    }

    // From the last row up: how wide the tree below each node is, and where the node stands in it.
    std::vector<double> widths(count), places(count), shifts(count);
    for (std::size_t row = graph.rows.size(); row-- > 0;) {
        budget.check();
        for (const std::size_t i : graph.rows[row]) {
            const double own = node_size(graph.nodes[i]).x + gap;
            double below = 0;
            for (const std::size_t child : children[i]) below += widths[child];
            widths[i] = std::max(own, below);
            shifts[i] = (widths[i] - below) / 2;
            places[i] = widths[i] / 2;
            if (below < own) continue;
            const std::size_t first = children[i].front(), last = children[i].back();
            places[i] = (places[first] + widths[i] - widths[last] + places[last]) / 2;
            places[i] = std::clamp(places[i], own / 2, widths[i] - own / 2);
        }
    }

    GraphLayout layout;
    layout.nodes.resize(count);
    std::vector<double> lefts(count);
    double flattest = 0;
    for (const std::vector<std::size_t>& row : graph.rows)
        for (const std::size_t i : row) {
            if (!is_child[i]) {
                lefts[i] = layout.width;
                layout.width += widths[i];
            }
            layout.nodes[i].x = lefts[i] + places[i];
            double left = lefts[i] + shifts[i];
            for (const std::size_t child : children[i]) {
                lefts[child] = left;
                left += widths[child];
                flattest =
                    std::max(flattest, std::fabs(lefts[child] + places[child] - layout.nodes[i].x));
            }
        }
    const double row_height = std::clamp(flattest * least_slope, least_row, largest_row);
    double tallest = 0;
    for (std::size_t row = 0; row < graph.rows.size(); ++row)
        for (const std::size_t i : graph.rows[row]) {
            const double height = node_size(graph.nodes[i]).y;
            tallest = std::max(tallest, height);
            layout.nodes[i].y = static_cast<double>(row) * row_height;
            layout.height = std::max(layout.height, layout.nodes[i].y + height / 2);
        }
    for (Point& node : layout.nodes) node.y += tallest / 2;
    layout.height += tallest / 2;

    for (const Graph::Edge& edge : graph.edges) {
        const Point &from = layout.nodes[edge.from], &to = layout.nodes[edge.to];
        const Point start = edge_end(from, to, graph.nodes[edge.from]);
        const Point end = edge_end(to, from, graph.nodes[edge.to]);
        const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
        layout.edges.push_back({{start, start, end, end}, std::nullopt, middle});
    }
    return layout;
}

}  // namespace algae
