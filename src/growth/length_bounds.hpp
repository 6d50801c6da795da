#pragma once

#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "system/d0l.hpp"
#include "system/ol.hpp"

namespace algae {

/// How short and how long the words of an 0L system can be, generation by generation.
struct LengthBounds {
    std::vector<Integer> least, most;  // of generations 0, 1, ..., n
    /// By letter of `OL::letters`: which of its successors leads to the shortest, or the longest, word
    /// when all n steps are still to go; the first one of several.
    std::vector<std::size_t> least_choice, most_choice;
};

/// Exact, for generations 0 to n: letters choose apart from each other, so
/// least(a, n) is the minimum over its successors u of the sum of least(b, n-1) over the letters b
/// of u, and the same with the maximum. O(n * size of the rules) additions.
///
/// Example: length_bounds(ol("a", {{'a', "a"}, {'a', "aa"}}), 3).most == std::vector<Integer>{1, 2, 4, 8}
LengthBounds length_bounds(const OL& system, std::uint64_t n, const Budget& budget = {});

/// The D0L system in which every accessible letter always makes this choice.
D0L chosen_system(const OL& system, const std::vector<std::size_t>& choices);

}  // namespace algae
