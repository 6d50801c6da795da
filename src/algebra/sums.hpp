#pragma once

#include <vector>

#include "algebra/monoid.hpp"
#include "exact/integer.hpp"

namespace algae {

/// The natural numbers (or all integers) under addition. `bracket_pair` is what a pair of brackets
/// adds: 2 where brackets count as letters, 0 where only what stands between them counts.
struct Sums {
    using value_type = Integer;
    Integer bracket_pair = 2;

    Integer one() const { return 0; }
    void append(Integer& left, const Integer& right) const { left += right; }
    Integer branch(const Integer& twig) const { return twig + bracket_pair; }
};

/// Vectors of integers under addition: Parikh vectors.
struct Vectors {
    using value_type = std::vector<Integer>;
    std::size_t dimension = 0;

    value_type one() const { return value_type(dimension); }
    void append(value_type& left, const value_type& right) const {
        for (std::size_t i = 0; i < dimension; ++i) left[i] += right[i];
    }
};

/// How deep a word goes into brackets: `depth` at its end relative to its start, `lowest` the least
/// depth of any prefix. A word is balanced when both are 0.
struct BracketBalance {
    struct value_type {
        Integer depth = 0;
        Integer lowest = 0;
        bool operator==(const value_type&) const = default;
    };
    value_type one() const { return {}; }
    void append(value_type& left, const value_type& right) const {
        const Integer reached = left.depth + right.lowest;
        if (reached < left.lowest) left.lowest = reached;
        left.depth += right.depth;
    }
};

}  // namespace algae
