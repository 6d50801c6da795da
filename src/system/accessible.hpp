#pragma once

#include <vector>

#include "word/alphabet.hpp"

namespace algae {

/// The letters that occur in some word derived from the axiom, in order of first access. `successors(a, see)`
/// calls `see` with every word that the letter may become; `letters` is how many symbols there are.
template <class Successors>
std::vector<Symbol> accessible(const Word& axiom, std::size_t letters, Successors successors) {
    std::vector<char> seen(letters, 0);
    std::vector<Symbol> found;
    const auto see = [&](const Word& word) {
        for (const Symbol a : word)
            if (!seen[a]) {
                seen[a] = 1;
                found.push_back(a);
            }
    };
    see(axiom);
    for (std::size_t i = 0; i < found.size(); ++i) successors(found[i], see);
    return found;
}

}  // namespace algae
