#include "render/tree.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "render/graph_letter.hpp"

namespace algae {

namespace {

using Kind = DerivationTree::Node::Kind;

/// "377", "3.5e20" for what has many digits; "ε" for nothing.
std::string leaves_text(const Integer& leaves) {
    if (leaves < 0) return "...";
    if (leaves == 0) return "ε";
    const std::string digits = to_string(leaves);
    if (digits.size() <= 6) return digits;
    return digits.substr(0, 1) + "." + digits.substr(1, 1) + "e" +
           std::to_string(digits.size() - 1);
}

/// The letters that somewhere become something else than themselves, or are never rewritten in the
/// tree, in order of first occurrence.
std::vector<Symbol> rewritten_letters(const DerivationTree& tree) {
    std::vector<Symbol> order;
    std::map<Symbol, bool> stays;  // of letters that have children
    for (const auto& node : tree.nodes) {
        if (node.kind != Kind::letter) continue;
        if (std::find(order.begin(), order.end(), node.letter) == order.end())
            order.push_back(node.letter);
        if (node.children.empty()) continue;
        const auto& child = tree.nodes[node.children.front()];
        if (child.kind == Kind::omitted) continue;
        const bool same =
            node.children.size() == 1 && child.kind == Kind::letter && child.letter == node.letter;
        const auto known = stays.emplace(node.letter, same).first;
        known->second = known->second && same;
    }
    std::erase_if(order, [&](Symbol a) { return stays.contains(a) && stays[a]; });
    return order;
}

bool is_shared(const DerivationTree& tree) {
    return tree.roots.size() + edge_count(tree) != tree.nodes.size();
}

}  // namespace

Graph tree_graph(const DerivationTree& tree) {
    Graph graph;
    graph.straight = true;
    graph.ordered = true;
    graph.trees = !is_shared(tree);
    const std::vector<Symbol> rewritten = rewritten_letters(tree);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const auto& node = tree.nodes[i];
        Graph::Node drawn;
        if (node.kind == Kind::erased) {
            drawn.label = "ε";
            drawn.shape = Graph::Node::Shape::bare;
        } else if (node.kind == Kind::omitted) {
            drawn.label = leaves_text(node.leaves);
            drawn.shape = Graph::Node::Shape::triangle;
        } else {
            drawn = letter_node(*tree.alphabet, node.letter);
            const auto found = std::find(rewritten.begin(), rewritten.end(), node.letter);
            if (found == rewritten.end())
                drawn.shape = Graph::Node::Shape::bare;
            else if (rewritten.size() <= tints.size())
                drawn.fill = tints[static_cast<std::size_t>(found - rewritten.begin())];
        }
        graph.nodes.push_back(std::move(drawn));
        if (graph.rows.size() <= node.generation) graph.rows.resize(node.generation + 1);
        graph.rows[node.generation].push_back(i);

        std::vector<std::pair<std::size_t, std::size_t>> below;  // each child once, and how often
        for (const std::size_t child : node.children) {
            const auto known = std::find_if(below.begin(), below.end(),
                                            [&](const auto& one) { return one.first == child; });
            if (known == below.end())
                below.emplace_back(child, 1);
            else
                ++known->second;
        }
        for (const auto& [child, times] : below) {
            Graph::Edge edge;
            edge.from = i;
            edge.to = child;
            if (times > 1) edge.label = "×" + std::to_string(times);
            graph.edges.push_back(std::move(edge));
        }
    }
    // Rows of nothing but marks are no generation of their own.
    for (std::size_t t = 0; t < graph.rows.size(); ++t) {
        const bool letters =
            std::any_of(graph.rows[t].begin(), graph.rows[t].end(),
                        [&](std::size_t i) { return tree.nodes[i].kind != Kind::omitted; });
        std::string label = letters ? std::to_string(t) : "";
        if (letters && t > 0 && t <= tree.tables.size()) label = tree.tables[t - 1] + "  " + label;
        graph.row_labels.push_back(std::move(label));
    }
    return graph;
}

}  // namespace algae
