#include "render/graph_growth.hpp"

#include <algorithm>
#include <array>

#include "growth/components.hpp"
#include "growth/growth_matrix.hpp"
#include "growth/letters.hpp"
#include "render/graph_letter.hpp"

namespace algae {

namespace {

enum class Fate { mortal, passing, cycle, expanding };

constexpr std::array fates{Fate::expanding, Fate::cycle, Fate::passing, Fate::mortal};

Colour colour_of(Fate fate) {
    switch (fate) {
        case Fate::mortal:
            return {0.88, 0.88, 0.89};
        case Fate::passing:
            return {1, 1, 1};
        case Fate::cycle:
            return {0.78, 0.87, 0.96};
        case Fate::expanding:
            return {0.99, 0.83, 0.66};
    }
    return {};
}

/// A paler shade, behind letters of the colour.
Colour frame_colour(Fate fate) {
    const Colour colour = colour_of(fate);
    const auto pale = [](double share) { return 1 - (1 - share) * 0.35; };
    return {pale(colour.red), pale(colour.green), pale(colour.blue)};
}

const char* meaning(Fate fate) {
    switch (fate) {
        case Fate::mortal:
            return "mortal";
        case Fate::passing:
            return "passes, never comes back";
        case Fate::cycle:
            return "comes back once a round";
        case Fate::expanding:
            return "multiplies";
    }
    return "";
}

/// "(1+√5)/2": roots with their sign, as one writes them.
std::string with_roots(std::string text) {
    const std::string name = "sqrt(";
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at)) {
        const std::size_t end = text.find_first_not_of("0123456789", at + name.size());
        if (end == std::string::npos || text[end] != ')') {
            at += name.size();
            continue;
        }
        text.replace(end, 1, "");
        text.replace(at, name.size(), "√");
    }
    return text;
}

std::string rate_text(const Rate& rate) {
    if (rate.integer()) return "rate " + rate.exact();
    const std::string exact = with_roots(rate.exact()), decimal = rate.decimal(5) + "...";
    return exact.size() > 24 ? "rate " + decimal : "rate " + exact + " = " + decimal;
}

}  // namespace

Graph growth_graph(const D0L& system, const Budget& budget) {
    const GrowthMatrix matrix = growth_matrix(system);
    const Components found = components(matrix, budget);
    const auto lives = lifetimes(matrix);
    Graph graph;
    std::vector<Fate> of_component;
    for (const Component& component : found.list) {
        Fate fate = Fate::passing;
        if (component.rate)
            fate = *component.rate == Rate(1) ? Fate::cycle : Fate::expanding;
        else if (lives[component.letters.front()])
            fate = Fate::mortal;
        of_component.push_back(fate);
    }
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        Graph::Node node = letter_node(*system.alphabet, system.letters[i]);
        node.fill = colour_of(of_component[found.of_letter[i]]);
        graph.nodes.push_back(std::move(node));
        for (const GrowthMatrix::Entry& entry : matrix.rows[i]) {
            Graph::Edge edge;
            edge.from = i;
            edge.to = entry.column;
            if (entry.times > 1) edge.label = "×" + to_string(entry.times);
            edge.arrow = true;
            graph.edges.push_back(std::move(edge));
        }
    }
    const std::vector<Integer> in_axiom = axiom_counts(system);
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        if (in_axiom[i] == 0) continue;
        Graph::Node start;
        start.shape = Graph::Node::Shape::start;
        Graph::Edge edge;
        edge.from = graph.nodes.size();
        edge.to = i;
        if (in_axiom[i] > 1) edge.label = "×" + to_string(in_axiom[i]);
        edge.arrow = true;
        graph.nodes.push_back(start);
        graph.edges.push_back(std::move(edge));
    }
    // What stands before others in the list occurs below them, so frames are given from above.
    for (std::size_t k = found.list.size(); k-- > 0;) {
        const Component& component = found.list[k];
        const Fate fate = of_component[k];
        const bool framed =
            fate == Fate::expanding || (fate == Fate::cycle && component.letters.size() > 1);
        if (!framed) continue;
        Graph::Group group;
        group.label = fate == Fate::expanding
                          ? rate_text(*component.rate)
                          : "cycle of " + std::to_string(component.letters.size());
        group.fill = frame_colour(fate);
        group.nodes = component.letters;
        graph.groups.push_back(std::move(group));
    }
    for (const Fate fate : fates)
        if (std::find(of_component.begin(), of_component.end(), fate) != of_component.end())
            graph.keys.push_back({colour_of(fate), meaning(fate)});
    return graph;
}

}  // namespace algae
