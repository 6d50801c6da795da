#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "exact/integer_matrix.hpp"
#include "system/d0l.hpp"

namespace algae {

/// A square matrix of natural numbers without its zeros, row by row. The growth matrix of a system
/// has one row for each accessible letter, with as many entries as its successor has letters.
struct GrowthMatrix {
    struct Entry {
        std::size_t column;
        Integer times;
        bool operator==(const Entry&) const = default;
    };
    std::vector<std::vector<Entry>> rows;  // columns ascending

    std::size_t size() const { return rows.size(); }
    bool operator==(const GrowthMatrix&) const = default;
};

/// The matrix of `incidence_matrix`.
///
/// Example: growth_matrix(d0l("a", {{'a', "aba"}, {'b', ""}})).rows[0].size() == 2
GrowthMatrix growth_matrix(const D0L& system);
GrowthMatrix growth_matrix(const IntegerMatrix& matrix);
IntegerMatrix dense(const GrowthMatrix& matrix);

/// How often each accessible letter occurs in the axiom.
std::vector<Integer> axiom_counts(const D0L& system);

/// A row vector times the matrix: from the letters of one generation to those of the next.
std::vector<Integer> operator*(const std::vector<Integer>& row, const GrowthMatrix& matrix);
/// The matrix times a column vector.
std::vector<Integer> operator*(const GrowthMatrix& matrix, const std::vector<Integer>& column);

/// The lengths of the words of generations 0 to count - 1.
///
/// Example: lengths(d0l("b", {{'a', "ab"}, {'b', "a"}}), 5) == std::vector<Integer>{1, 1, 2, 3, 5}
std::vector<Integer> lengths(const D0L& system, std::uint64_t count, const Budget& budget = {});

}  // namespace algae
