#pragma once

#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "verify/finite_language.hpp"
#include "verify/finite_obstruction.hpp"

namespace algae {

/// A finite language as a tree of beginnings, with every factor of its words numbered: what the
/// search for rules looks at, all in numbers. Letters are numbered by their place in `letters`.
class FiniteWords {
public:
    using Image = std::uint32_t;  // number of a factor
    using Node = std::uint32_t;   // number of a beginning; 0 is the empty one
    static constexpr std::uint32_t none = 0xffffffff;

    /// Throws BoundReached if the factors take more than the budget's memory. Quadratic in the
    /// lengths of the words.
    FiniteWords(const FiniteLanguage& language, const Budget& budget);

    struct Step {
        Image image;
        Node end;
    };

    std::vector<Symbol> letters;
    std::vector<std::vector<std::uint32_t>> words;  // with letters by number
    std::vector<Word> images;              // shorter ones first; images[0] is the empty word
    std::vector<std::vector<Step>> below;  // by node: every image that leads on, and where
    std::vector<std::uint32_t> word_at;    // by node: the word that ends there, or none
    std::vector<std::vector<std::uint32_t>> node_path;  // by word: the nodes of its beginnings

    std::size_t count() const { return words.size(); }
};

}  // namespace algae
