#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "exact/exact.hpp"
#include "system/system.hpp"

// Bracketed words as axial trees, and tree 0L-systems, which replace edges by trees
// (Prusinkiewicz and Lindenmayer 1990, 1.6).
//
// Reading brackets and deriving commute, which the tests use as the second route. Equality up to the order of lateral
// branches is decided by classes of subtrees (Aho, Hopcroft and Ullman 1974, 3.2).

namespace algae {

namespace {

/// Where the next letter of an axis goes: the vertex, and whether it starts a lateral axis there.
struct Tip {
    std::size_t vertex = 0;
    bool straight = true;
};

/// The edges that leave each vertex, in order, those of vertex v from first[v] to first[v + 1].
struct Leaving {
    std::vector<std::size_t> first, edges;

    explicit Leaving(const AxialTree& tree)
        : first(tree.edges.size() + 2, 0), edges(tree.edges.size()) {
        for (const auto& edge : tree.edges) ++first[edge.start + 1];
        for (std::size_t v = 0; v + 1 < first.size(); ++v) first[v + 1] += first[v];
        std::vector<std::size_t> next(first.begin(), first.end() - 1);
        for (std::size_t i = 0; i < tree.edges.size(); ++i) edges[next[tree.edges[i].start]++] = i;
    }
};

/// Calls open(edge), edge(edge) and close() as the word goes through the tree, lateral branches of
/// a vertex before what goes straight on.
template <class Open, class Visit, class Close>
void walk(const AxialTree& tree, const Leaving& leaving, Open open, Visit visit, Close close) {
    struct Step {
        std::size_t edge;
        bool closes;
    };
    std::vector<Step> stack;
    const auto leave = [&](std::size_t vertex) {  // pushed last is visited first
        const auto begin = leaving.first[vertex], end = leaving.first[vertex + 1];
        for (const bool straight : {true, false})
            for (std::size_t i = end; i-- > begin;) {
                const std::size_t edge = leaving.edges[i];
                if (tree.edges[edge].straight != straight) continue;
                if (!straight) stack.push_back({edge, true});
                stack.push_back({edge, false});
            }
    };
    leave(0);
    while (!stack.empty()) {
        const Step step = stack.back();
        stack.pop_back();
        if (step.closes) {
            close();
            continue;
        }
        if (!tree.edges[step.edge].straight) open();
        visit(step.edge);
        leave(step.edge + 1);
    }
}

}  // namespace

AxialTree axial_tree(const Word& word, const Brackets& brackets) {
    AxialTree tree;
    std::vector<Tip> tips{{}};
    for (const Symbol a : word) {
        if (a == brackets.open) {
            tips.push_back({tips.back().vertex, false});
        } else if (a == brackets.close) {
            if (tips.size() == 1) throw Error("unmatched ']'");
            tips.pop_back();
        } else {
            tree.edges.push_back({a, tips.back().vertex, tips.back().straight});
            tips.back() = {tree.edges.size(), true};
        }
    }
    if (tips.size() > 1) throw Error("'[' is never closed");
    return tree;
}

AxialTree restricted(const AxialTree& tree, const std::vector<char>& labels) {
    AxialTree out;
    std::vector<Tip> tips(tree.edges.size() + 1);
    for (std::size_t i = 0; i < tree.edges.size(); ++i) {
        const auto& edge = tree.edges[i];
        const Tip start{tips[edge.start].vertex, edge.straight && tips[edge.start].straight};
        tips[i + 1] = start;
        if (!labels.at(edge.label)) continue;
        out.edges.push_back({edge.label, start.vertex, start.straight});
        tips[i + 1] = {out.edges.size(), true};
    }
    return out;
}

Word bracketed_word(const AxialTree& tree, const Brackets& brackets) {
    Word word;
    walk(
        tree, Leaving(tree), [&] { word.push_back(brackets.open); },
        [&](std::size_t edge) { word.push_back(tree.edges[edge].label); },
        [&] { word.push_back(brackets.close); });
    return word;
}

AxialTree canonical(const AxialTree& tree) {
    // Equal branches get equal numbers, from the leaves down: ends of edges stand behind starts.
    using Form = std::tuple<Symbol, bool, std::vector<std::size_t>>;
    std::map<Form, std::size_t> forms;
    std::vector<std::size_t> form(tree.edges.size());
    const Leaving leaving(tree);
    for (std::size_t i = tree.edges.size(); i-- > 0;) {
        std::vector<std::size_t> branches;
        for (std::size_t k = leaving.first[i + 1]; k < leaving.first[i + 2]; ++k)
            branches.push_back(form[leaving.edges[k]]);
        std::sort(branches.begin(), branches.end());
        form[i] =
            forms
                .emplace(Form{tree.edges[i].label, tree.edges[i].straight, std::move(branches)},
                         forms.size())
                .first->second;
    }
    // The numbers depend on the order of the edges, so forms are ranked by what they contain.
    std::vector<const Form*> by_number(forms.size());
    for (const auto& [contents, number] : forms) by_number[number] = &contents;
    std::vector<std::size_t> rank(forms.size());
    std::vector<std::vector<std::size_t>> by_height;
    std::vector<std::size_t> height(forms.size(), 0);
    for (std::size_t number = 0; number < by_number.size(); ++number) {
        for (const std::size_t inner : std::get<2>(*by_number[number]))
            height[number] = std::max(height[number], height[inner] + 1);
        if (by_height.size() <= height[number]) by_height.resize(height[number] + 1);
        by_height[height[number]].push_back(number);
    }
    std::size_t next = 0;
    for (const auto& level : by_height) {
        std::vector<std::pair<Form, std::size_t>> sorted;
        for (const std::size_t number : level) {
            auto [label, straight, inner] = *by_number[number];
            for (std::size_t& branch : inner) branch = rank[branch];
            std::sort(inner.begin(), inner.end());
            sorted.emplace_back(Form{label, straight, std::move(inner)}, number);
        }
        std::sort(sorted.begin(), sorted.end());
        for (const auto& [contents, number] : sorted) rank[number] = next++;
    }
    Leaving ordered = leaving;
    for (std::size_t v = 0; v <= tree.edges.size(); ++v)
        std::sort(ordered.edges.begin() + static_cast<std::ptrdiff_t>(ordered.first[v]),
                  ordered.edges.begin() + static_cast<std::ptrdiff_t>(ordered.first[v + 1]),
                  [&](std::size_t a, std::size_t b) { return rank[form[a]] < rank[form[b]]; });
    AxialTree out;
    std::vector<std::size_t> place(tree.edges.size() + 1, 0);  // of the old vertices
    walk(
        tree, ordered, [] {},
        [&](std::size_t edge) {
            const auto& old = tree.edges[edge];
            out.edges.push_back({old.label, place[old.start], old.straight});
            place[edge + 1] = out.edges.size();
        },
        [] {});
    return out;
}

std::vector<std::size_t> axis_orders(const AxialTree& tree) {
    std::vector<std::size_t> orders;
    orders.reserve(tree.edges.size());
    for (const auto& edge : tree.edges) {
        const std::size_t before = edge.start == 0 ? 0 : orders[edge.start - 1];
        orders.push_back(edge.straight ? before : before + 1);
    }
    return orders;
}

std::vector<OrderCount> order_counts(const AxialTree& tree) {
    const std::vector<std::size_t> orders = axis_orders(tree);
    std::vector<OrderCount> counts;
    for (std::size_t i = 0; i < orders.size(); ++i) {
        if (counts.size() <= orders[i]) counts.resize(orders[i] + 1);
        ++counts[orders[i]].edges;
        const auto& edge = tree.edges[i];
        if (!edge.straight || edge.start == 0) ++counts[orders[i]].axes;
    }
    return counts;
}

View<TreeSystem> as_tree_system(const D0L& system) {
    TreeSystem trees;
    trees.alphabet = system.alphabet;
    if (system.brackets) {
        trees.brackets = *system.brackets;
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
