#pragma once

#include "language/derivation_tree.hpp"
#include "render/graph.hpp"

namespace algae {

/// The picture of a derivation tree: one row a generation, every row in word order, so that the
/// last row reads as the word. Letters that are rewritten have a colour each where there are few of
/// them; letters that stay as they are stand bare, erased ones end in ε, and a triangle stands for
/// what is cut off, with the number of letters it derives. Where subtrees are shared (a letter of a
/// generation with several edges to it), an edge says how often the letter below occurs in the
/// successor.
///
/// Example: tree_graph(derivation_tree(d0l("b", {{'a', "ab"}, {'b', "a"}}), 3)).rows.size() == 4
Graph tree_graph(const DerivationTree& tree);

}  // namespace algae
