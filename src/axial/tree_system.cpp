#include "axial/tree_system.hpp"

#include <string>

#include "base/error.hpp"

namespace algae {

View<TreeSystem> as_tree_system(const D0L& system) {
    TreeSystem trees;
    trees.alphabet = system.alphabet;
    if (system.rules.brackets) {
        trees.brackets = *system.rules.brackets;
    } else if (brackets_of(*system.alphabet)) {
        return View<TreeSystem>::refused(
            "not a tree 0L-system: its brackets are rewritten, or do not match in the "
            "axiom or in a successor");
    } else {
        // Symbols that no word has.
        const auto beyond = static_cast<Symbol>(system.alphabet->size());
        trees.brackets = {beyond, beyond + 1};
    }
    trees.axiom = axial_tree(system.axiom, trees.brackets);
    trees.images.resize(system.alphabet->size());
    for (const Symbol a : system.letters)
        if (a != trees.brackets.open && a != trees.brackets.close)
            trees.images[a] = axial_tree(system.successor(a), trees.brackets);
    return trees;
}

AxialTree next_tree(const TreeSystem& system, const AxialTree& tree, const Budget& budget) {
    /// Where an old vertex has come to lie, and whether an edge that goes straight on there does so
    /// still, because something of its axis is left before it.
    struct Tip {
        std::size_t vertex = 0;
        bool straight = true;
    };
    AxialTree out;
    std::vector<Tip> tips(tree.edges.size() + 1);
    std::vector<std::size_t> places;  // of the vertices of the replacement
    for (std::size_t i = 0; i < tree.edges.size(); ++i) {
        if (i % 4096 == 0) budget.check();
        const AxialTree::Edge& edge = tree.edges[i];
        const AxialTree& image = system.images.at(edge.label);
        if (out.edges.size() + image.edges.size() > budget.letters)
            throw BoundReached(Bound::letters, "the tree has more edges than the " +
                                                   std::to_string(budget.letters) + " allowed" +
                                                   budget.by(Bound::letters));
        Tip tip{tips[edge.start].vertex, edge.straight && tips[edge.start].straight};
        std::size_t axis =
            0;  // the vertex of the replacement where its axis of order 0 has come to
        places.assign(1, tip.vertex);
        for (std::size_t k = 0; k < image.edges.size(); ++k) {
            const AxialTree::Edge& part = image.edges[k];
            const bool on_axis = part.straight && part.start == axis;
            out.edges.push_back(
                {part.label, places[part.start], on_axis ? tip.straight : part.straight});
            places.push_back(out.edges.size());
            if (!on_axis) continue;
            axis = k + 1;
            tip = {out.edges.size(), true};
        }
        tips[i + 1] = tip;
    }
    return out;
}

AxialTree derived_tree(const TreeSystem& system, std::uint64_t n, const Budget& budget) {
    AxialTree tree = system.axiom;
    for (std::uint64_t step = 0; step < n; ++step) tree = next_tree(system, tree, budget);
    return tree;
}

}  // namespace algae
