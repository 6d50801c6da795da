#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "combinatorics/combinatorics.hpp"

// The words derived by returns, level by level, and what of a factor of one is seen in the one before.

namespace algae {

using Pairs = std::vector<std::pair<Symbol, Symbol>>;  // in order, each once
using Counts = std::vector<Integer>;                   // of each letter of a word
using Images = std::vector<Word>;  // of letters 0, 1, ...; 0 is the first letter of the word

inline constexpr std::size_t most_levels = 2'000;
inline constexpr std::size_t most_letters =
    4'000'000;  // of the images at one level, and of a return word

/// Throws BoundReached: the words derived by returns are too large in this way.
[[noreturn]] void too_large(const std::string& what);

Integer size(const Counts& counts);
Counts sum(Counts left, const Counts& right);

/// The bilateral multiplicity of a word with these pairs of letters around it; nothing if it is not bispecial.
std::optional<std::int64_t> multiplicity(const Pairs& pairs);

/// An image of a bispecial word: what is added to the image of its letters, and its own pairs.
struct BispecialImage {
    Pairs pairs;
    Counts added;
};

/// A bispecial factor without the first letter.
struct BispecialRoot {
    Pairs pairs;
    Counts counts;
};

/// One derived word, as far as its factors are seen from the return words that make it of the next one.
class DerivedLevel {
public:
    explicit DerivedLevel(Images returns);

    std::size_t letters() const { return letters_; }
    const Images& returns() const { return returns_; }
    /// The numbers of letters of the image of a word under the return words.
    Counts image(const Counts& counts) const;
    /// Of a bispecial factor of the next derived word, those of this one that come of it.
    std::vector<BispecialImage> images(const Pairs& pairs) const;
    /// The bispecial factors of this derived word that have no 0.
    std::vector<BispecialRoot> roots() const;

private:
    struct Place {
        std::size_t text, begin;
    };

    void look(const std::vector<Word>& texts, const std::vector<Place>& places, std::size_t length,
              std::vector<BispecialRoot>& found) const;
    const std::map<Symbol, std::size_t>& parikh(std::size_t b) const;

    Images returns_;
    std::size_t letters_ = 1;
    mutable std::vector<std::map<Symbol, std::size_t>> parikh_;
};

std::vector<DerivedLevel> levels_of(DerivedWords all);

}  // namespace algae
