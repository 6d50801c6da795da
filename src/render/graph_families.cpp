#include "render/graph_families.hpp"

#include <algorithm>
#include <string>

namespace algae {

namespace {

const Colour chomsky{0.99, 0.87, 0.68}, pure{0.78, 0.87, 0.96}, extended{0.80, 0.92, 0.77};

std::size_t node_of(Graph& graph, const std::string& family) {
    const auto found = std::find_if(graph.nodes.begin(), graph.nodes.end(),
                                    [&](const Graph::Node& node) { return node.label == family; });
    if (found != graph.nodes.end()) return static_cast<std::size_t>(found - graph.nodes.begin());
    Graph::Node node;
    node.label = family;
    node.shape = Graph::Node::Shape::box;
    node.fill = !family.ends_with("L") ? chomsky : family.starts_with("E") ? extended : pure;
    graph.nodes.push_back(std::move(node));
    return graph.nodes.size() - 1;
}

Graph::Edge edge(Graph& graph, const char* lower, const char* upper) {
    Graph::Edge found;
    found.from = node_of(graph, lower);
    found.to = node_of(graph, upper);
    return found;
}

}  // namespace

const std::vector<std::pair<const char*, const char*>>& family_inclusions() {
    static const std::vector<std::pair<const char*, const char*>> inclusions{
        {"PD0L", "D0L"},  {"PD0L", "P0L"}, {"D0L", "0L"},     {"P0L", "0L"},  {"D0L", "DT0L"},
        {"0L", "T0L"},    {"DT0L", "T0L"}, {"0L", "E0L"},     {"0L", "IL"},   {"DT0L", "EDT0L"},
        {"T0L", "ET0L"},  {"E0L", "ET0L"}, {"EDT0L", "ET0L"}, {"FIN", "REG"}, {"REG", "CF"},
        {"REG", "EDT0L"}, {"REG", "IL"},    {"CF", "E0L"},     {"ET0L", "CS"},
    };
    return inclusions;
}

Graph families_graph() {
    Graph graph;
    graph.upward = true;
    for (const auto& [lower, upper] : family_inclusions())
        graph.edges.push_back(edge(graph, lower, upper));
    for (const char* family : {"REG", "CF"}) {
        Graph::Edge incomparable = edge(graph, "0L", family);
        incomparable.dashed = true;
        incomparable.places = false;
        graph.edges.push_back(incomparable);
    }
    graph.keys = {
        {chomsky, "Chomsky's families and FIN"}, {pure, "L-systems"}, {extended, "with terminals"}};
    graph.caption = "A line leads up to a larger family; dashed: neither contains the other";
    return graph;
}

}  // namespace algae
