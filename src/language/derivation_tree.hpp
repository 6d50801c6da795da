#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "language/membership.hpp"
#include "system/d0l.hpp"
#include "system/et0l.hpp"

namespace algae {

/// A derivation as a tree; as several trees side by side where the axiom has several letters. The
/// children of a letter are the letters of its successor.
struct DerivationTree {
    struct Node {
        enum class Kind {
            letter,
            erased,   // the empty word, below a letter whose successor it is
            omitted,  // everything below a letter at which the tree was cut
        };
        Kind kind = Kind::letter;
        Symbol letter = 0;             // omitted: the letter above; erased: 0
        std::uint64_t generation = 0;  // of the letter; erased and omitted: one more than above
        Integer leaves = 0;  // omitted: letters of the last generation, -1 if beyond count
        std::vector<std::size_t> children;  // from left to right, as places in `nodes`
        bool operator==(const Node&) const = default;
    };
    std::shared_ptr<const Alphabet> alphabet;
    std::vector<std::size_t> roots;  // the letters of the axiom
    std::vector<Node> nodes;         // generation after generation, in each from left to right
    std::vector<std::string>
        tables;  // the names of the tables that the steps use; empty with one table
};

/// How a derivation is shown.
struct TreeShape {
    std::optional<std::uint64_t>
        depth;            // the last generation shown, one mark below each of its letters
    bool shared = false;  // equal subtrees of one generation are one: no tree any more
};

/// How many nodes the tree of generation n has, without the tree: the length of a generation of a
/// system in which every letter leaves one more letter behind. Of a tree with shared subtrees by
/// the sets of letters of each generation, until they repeat. Throws what `length` throws.
///
/// Example: tree_size(d0l("b", {{'a', "ab"}, {'b', "a"}}), 31) == 5702886
Integer tree_size(const D0L& system, std::uint64_t n, const TreeShape& shape = {},
                  const Budget& budget = {});

/// The tree of generation n. Throws BoundReached if it has more nodes than budget.letters.
///
/// Example: derivation_tree(d0l("b", {{'a', "ab"}, {'b', "a"}}), 3).nodes.size() == 7
DerivationTree derivation_tree(const D0L& system, std::uint64_t n, const TreeShape& shape = {},
                               const Budget& budget = {});

/// The same of a derivation. Linear time, n log n with shared subtrees.
Integer tree_size(const ET0L& system, const Derivation& derivation, const TreeShape& shape = {},
                  const Budget& budget = {});
DerivationTree derivation_tree(const ET0L& system, const Derivation& derivation,
                               const TreeShape& shape = {}, const Budget& budget = {});

/// A depth below n at which a tree is small enough to show, and the next depth is not, if depth 0
/// is: `size` gives the size of the tree in a shape. O(log n) calls.
///
/// Example: depth_within(30, 100, [](const TreeShape& shape) { return Integer(*shape.depth + 1); }) == 29
std::optional<std::uint64_t> depth_within(std::uint64_t n, std::uint64_t most_nodes,
                                          const std::function<Integer(const TreeShape&)>& size,
                                          bool shared = false);

/// The same tree with equal subtrees of one generation made one, each at its first place.
DerivationTree with_shared_subtrees(const DerivationTree& tree, const Budget& budget = {});

/// How many generations there are below the axiom, marks of erased letters and of cuts not counted.
std::uint64_t depth(const DerivationTree& tree);

/// How many edges there are; a letter twice in a successor counts twice.
std::uint64_t edge_count(const DerivationTree& tree);

/// The word that the leaves spell from left to right, erased letters left out. Throws Error if the
/// tree is cut or has more leaves than budget.letters.
///
/// Example: leaves(derivation_tree(d0l("a", {{'a', "ab"}, {'b', ""}}), 2)) == Word{0, 1}
Word leaves(const DerivationTree& tree, const Budget& budget = {});

}  // namespace algae
