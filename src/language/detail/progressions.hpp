#pragma once

// The words of D0L systems whose lengths grow linearly.

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "language/language.hpp"

namespace algae {

/// A regular D0L language, infinite: w_0, ..., w_(first-1), and for n = first, ..., first + period - 1 the words
/// w_(n + k period) = u v^k x.
struct Progressions {
    struct Part {
        Word before, repeated, behind;  // u, v, x; v is not empty
    };
    std::uint64_t first = 0, period = 1;
    std::vector<Word> words;
    std::vector<Part> parts;  // of n = first, ...
};

/// The words of every `step`-th generation from `first` on: for each part in turn left^n word right^n, n = 0, 1, ...
/// `step` steps make left word right of each word, and keep what is left and right of it as it is.
struct SectionOfPowers {
    struct Part {
        Word left, word, right;
    };
    std::uint64_t first = 0, step = 1;
    std::vector<Part> parts;
};

/// Whether the language of a D0L system whose lengths grow linearly is regular: what its words are, or a section whose powers are
/// not of one period. Nothing if the lengths are bounded or grow faster. Throws what budget.check throws, BoundReached where cycles of letters
/// make a period so long that the words of one take more than budget.memory.
///
/// Example: std::get<Progressions>(*regularity(d0l("a", {{'a', "ab"}}))).words.empty()
/// Example: std::get<SectionOfPowers>(*regularity(d0l("a", {{'a', "bac"}}))).parts.size() == 3
std::optional<std::variant<Progressions, SectionOfPowers>> regularity(const D0L& system,
                                                                      const Budget& budget = {});

/// The same language as an expression.
Language as_expression(const Progressions& progressions);

}  // namespace algae
