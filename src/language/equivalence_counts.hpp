#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "growth/growth_matrix.hpp"
#include "language/sequence_pair.hpp"

namespace algae {

/// How often each letter occurs, by symbol (the Parikh vector of a word).
using LetterCounts = std::vector<Integer>;

/// The letter counts of the generations of a D0L system with an infinite language, as far as they are asked
/// for. No two are the same: counts that came again would come again for ever, and there are only finitely
/// many words with the same counts, but infinitely many generations, all of them different words.
class GenerationCounts {
public:
    /// The system and the budget must outlive it.
    GenerationCounts(const D0L& system, const Budget& budget);

    /// Works out generations 0 to size - 1. Throws BoundReached if they take more than budget.memory.
    void extend(std::uint64_t size);
    std::size_t size() const { return counts_.size(); }
    const LetterCounts& operator[](std::uint64_t generation) const {
        return counts_[static_cast<std::size_t>(generation)];
    }
    const Integer& length(std::uint64_t generation) const {
        return lengths_[static_cast<std::size_t>(generation)];
    }
    /// The generation with these counts, if it is one of those worked out.
    std::optional<std::uint64_t> generation_of(const LetterCounts& counts) const;
    /// All words of generation size() and later have at least so many letters: each such word has some
    /// letter that grows, `size()` steps later.
    Integer least_later_length() const;

private:
    const D0L& system_;
    const Budget& budget_;
    GrowthMatrix matrix_;
    std::vector<std::size_t> growing_;     // rows of the letters that grow
    std::vector<Integer> row_;             // of the next generation
    std::vector<Integer> letter_lengths_;  // of what each letter becomes in size() steps
    std::vector<LetterCounts> counts_;
    std::vector<Integer> lengths_;
    std::map<LetterCounts, std::uint64_t> generations_;
    std::uint64_t kept_ = 0;  // bytes
};

}  // namespace algae
