#pragma once

#include <memory>
#include <vector>

#include "axial/axial_tree.hpp"
#include "base/budget.hpp"
#include "system/d0l.hpp"
#include "system/view.hpp"

namespace algae {

/// A tree 0L-system (tree-0L; Prusinkiewicz and Lindenmayer 1990, 1.6.2), deterministic: an axial
/// tree and for each label the axial tree that replaces edges so labelled. The start of an edge
/// becomes the root of its replacement, its end the end of the replacement's axis of order 0.
struct TreeSystem {
    std::shared_ptr<const Alphabet> alphabet;
    Brackets brackets;
    AxialTree axiom;
    std::vector<AxialTree> images;  // by symbol
};

/// The tree system whose trees the words of a D0L system describe, if its brackets match in every
/// successor and are not rewritten. Without brackets trees have one axis.
View<TreeSystem> as_tree_system(const D0L& system);

/// The tree after one step: all edges replaced at once. Where a lateral edge is replaced by a tree
/// without an axis of order 0, what went straight on after it becomes lateral. Linear in the result.
/// Throws BoundReached if that has more edges than the budget's letters.
///
/// Deriving and reading commute: canonical(next_tree(s, axial_tree(w))) is
/// canonical(axial_tree(h(w))) for the morphism h of the words.
AxialTree next_tree(const TreeSystem& system, const AxialTree& tree, const Budget& budget = {});

/// The tree after n steps from the axiom.
AxialTree derived_tree(const TreeSystem& system, std::uint64_t n, const Budget& budget = {});

}  // namespace algae
