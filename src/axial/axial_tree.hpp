#pragma once
// axial: bracketed words as axial trees, and derivation on the trees themselves.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "word/hom.hpp"

namespace algae {

/// An axial tree (Prusinkiewicz and Lindenmayer 1990, 1.6.1): a rooted tree with labelled edges, of
/// which at most one leaving a vertex goes straight on; the others are lateral. Vertex 0 is the
/// root, and edge i ends at vertex i + 1 and starts at a vertex not above i.
struct AxialTree {
    struct Edge {
        Symbol label = 0;
        std::size_t start = 0;  // a vertex
        bool straight = true;
        bool operator==(const Edge&) const = default;
    };
    std::vector<Edge> edges;

    bool operator==(const AxialTree&) const = default;
};

/// The tree that a bracketed word describes, edges in the order of the word: in A[B]C, C goes on
/// straight after A and B is lateral. Brackets without letters leave nothing, and a bracket at the
/// beginning of another starts at the same vertex: A[[B]C] is A[B][C]. Throws Error if the brackets
/// do not match. Linear.
AxialTree axial_tree(const Word& word, const Brackets& brackets);

/// The tree without the edges whose labels are not among `labels` (by symbol): their ends fall on
/// their starts. F[+F] has two edges if + is none. Linear.
AxialTree restricted(const AxialTree& tree, const std::vector<char>& labels);

/// A word that describes the tree: at each vertex the lateral branches in the order of their first
/// edges, then what goes straight on. Linear.
Word bracketed_word(const AxialTree& tree, const Brackets& brackets);

/// The tree with the lateral branches of each vertex in a fixed order and edges in the order of the
/// word. Two trees are the same, whatever the order of their lateral branches, if and only if their
/// canonical trees are equal. O(n log n) by Aho, Hopcroft and Ullman's classes of subtrees.
AxialTree canonical(const AxialTree& tree);

/// The order of the axis of each edge: 0 for the axis at the root, n + 1 for one that starts
/// laterally on an axis of order n. Linear.
std::vector<std::size_t> axis_orders(const AxialTree& tree);

/// Axes and edges of one order.
struct OrderCount {
    std::uint64_t axes = 0, edges = 0;
    bool operator==(const OrderCount&) const = default;
};

/// How many axes and edges there are of each order, up to the greatest. Linear.
std::vector<OrderCount> order_counts(const AxialTree& tree);

}  // namespace algae
