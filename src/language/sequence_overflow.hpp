#pragma once

#include <cstddef>
#include <optional>
#include <tuple>

#include "language/sequence_pair.hpp"

namespace algae {

/// What one image of a word has beyond the other: where g and h are the rules of the left and the right
/// system, g(u) = h(u) word if the left is ahead, and g(u) word = h(u) if the right is. The empty
/// overflow counts as the left's.
struct Overflow {
    enum class Ahead { left, right };
    Ahead ahead = Ahead::left;
    Word word;
    bool operator==(const Overflow&) const = default;
    bool operator<(const Overflow& other) const {
        return std::tie(ahead, word) < std::tie(other.ahead, other.word);
    }
};

/// What a further letter makes of an overflow.
struct OverflowStep {
    std::optional<Overflow> next;  // none if the images differ at a letter that both have
    std::size_t agreed = 0;  // so many more letters does the shorter image share with the other
};

/// From u with this overflow to u a: what is ahead and the images of a are compared. Linear time.
///
/// Example: overflow_step(over_common_alphabet(d0l("a", {{'a', "ab"}}), d0l("a", {{'a', "a"}})), {}, 0).next->word == Word{1}
OverflowStep overflow_step(const SequencePair& systems, const Overflow& overflow, Symbol letter);

}  // namespace algae
