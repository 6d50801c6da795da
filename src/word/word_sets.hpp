#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "base/budget.hpp"
#include "word/alphabet.hpp"

namespace algae {

/// Finite sets of words under union and concatenation, all words longer than `longest` left out:
/// a semiring, because lengths add up. Sets are sorted in shortlex order over symbol numbers.
class WordSets {
public:
    using value_type = std::vector<Word>;

    /// `budget` bounds the memory of one set; it must outlive the semiring.
    explicit WordSets(const Budget& budget, std::size_t longest = std::numeric_limits<std::size_t>::max())
        : budget_(&budget), longest_(longest) {}

    value_type zero() const { return {}; }
    value_type one() const { return {Word{}}; }
    /// left := left united with right.
    void add(value_type& left, const value_type& right) const;
    /// left := all words u v, u from left, v from right. Throws BoundReached if they take more
    /// than the budget's memory.
    void append(value_type& left, const value_type& right) const;

private:
    const Budget* budget_;
    std::size_t longest_;
};

/// Shorter words first, then by symbol numbers.
bool shortlex_less(const Word& left, const Word& right);

}  // namespace algae
