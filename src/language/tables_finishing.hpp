#pragma once

#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "system/et0l.hpp"

namespace algae {

/// What letters can still do on the way to a word of L(G). A letter finishes by a sequence of
/// tables if it derives a word of terminals by it, perhaps the empty one; all letters of a word
/// must finish by what comes, so the set of letters that finish goes backwards from the terminals:
/// those that do by a table before the sequence have a successor in it whose letters do by the
/// sequence.
///
/// A stage is a letter and such a set that it belongs to. By a table a stage becomes each letter of
/// a successor all of whose letters finish. A stage counts if some way from the axiom, all of whose
/// letters finish, comes by.
struct FinishingSets {
    /// A step forwards: by a table to a set.
    struct Step {
        std::uint32_t table = 0;
        std::size_t to = 0;
    };

    std::vector<std::vector<char>>
        sets;  // of accessible letters, by symbol; the first is that of no tables: the terminals
    std::vector<std::vector<Step>> steps;  // from each set
    std::vector<std::vector<std::size_t>>
        before;  // before[set][table]: the set whose step by the table leads here
    std::vector<std::vector<char>> accessible;  // by set and symbol: whether the stage counts

    /// Whether all letters of the word finish by the tables that the set is of.
    bool finishes(std::size_t set, const Word& word) const;
};

/// By backward reachability: at most 2^letters sets, one where every letter is a terminal. Throws
/// BoundReached if they take more than budget.memory.
///
/// Example: finishing_sets(et0l("S", {{{'S', "a"}, {'a', "S"}}}, "a")).sets.size() == 2
FinishingSets finishing_sets(const ET0L& system, const Budget& budget = {});

}  // namespace algae
