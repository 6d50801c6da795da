#pragma once

#include "render/graph_layout.hpp"

namespace algae {

/// Places a graph whose edges make trees, a row a generation: leaves stand side by side at equal
/// distances in their order, a letter over the middle between its first and its last child, the
/// trees one beside the other. (Graphviz puts a letter with two children over one of them.) Linear
/// time.
GraphLayout tree_layout(const Graph& graph, const Budget& budget = {});

}  // namespace algae
