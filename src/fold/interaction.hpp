#pragma once

#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "system/il.hpp"

namespace algae {

/// The word after one step of a system with interactions. All letters are rewritten at once; beyond
/// the ends of the word no context matches. O(length of the word * number and size of the rules of
/// a letter).
///
/// There is no fold here: what a letter becomes is no function of the letter alone.
Word next_word(const IL& system, const Word& word);

/// The lengths of generations 0 to n, by deriving them. Throws BoundReached if a word has more than
/// budget.letters letters.
std::vector<std::uint64_t> derived_lengths(const IL& system, std::uint64_t n, const Budget& budget = {});

/// The word of generation n, by deriving. Throws as derived_lengths does.
Word derive(const IL& system, std::uint64_t n, const Budget& budget = {});

}  // namespace algae
