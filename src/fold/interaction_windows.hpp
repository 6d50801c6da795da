#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "system/il.hpp"

namespace algae {

/// What the fast ways of deriving need of a system with interactions: words are no trees, no letter
/// that occurs is ignored, so that what becomes of a letter is a function of a window of letters
/// around it. The letters that occur are numbered from 0 on.
struct Windows {
    std::vector<Symbol> letters;        // by number, in order of first access
    std::vector<std::uint8_t> numbers;  // by symbol; 0 too for letters that do not occur
    std::size_t left = 0, right = 0;    // letters of the window on either side
    bool keeps_length = true;           // every letter becomes one letter

    static constexpr std::size_t most_bits = 15;  // of the numbers in a window

    /// Bits that tell the numbers apart, at least 1.
    std::size_t bits() const;
    std::size_t width() const { return left + 1 + right; }
};

/// The windows of a system, if it has them and their letters can be told by few enough bits
/// (most_bits) to tabulate what becomes of each. O(size of the system).
std::optional<Windows> windows(const IL& system);

/// What the letter at this place of a word without trees and ignored letters becomes: beyond the
/// ends of the word nothing matches. The word must outlive the answer.
struct Letters {
    const Symbol* begin = nullptr;
    std::size_t size = 0;
};
Letters successor_at(const IL& system, const Word& word, std::size_t place);

/// successor_at in the middle of every window, by its number: the first letter of the window has the
/// lowest bits. Only windows of letters that occur have one. Numbers of letters.
std::vector<std::optional<std::vector<std::uint8_t>>> window_table(const IL& system,
                                                                   const Windows& windows);

}  // namespace algae
