#pragma once
// growth: growth functions of D0L systems, exactly.

#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "exact/integer_matrix.hpp"
#include "system/d0l.hpp"

namespace algae {

/// The growth matrix: entry (i, j) is how often the j-th accessible letter occurs in the successor
/// of the i-th, in the order of `system.letters` (Rozenberg and Salomaa 1980, I.3).
///
/// Example: incidence_matrix(d0l("b", {{'a', "ab"}, {'b', "a"}})) == IntegerMatrix({{0, 1}, {1, 1}})
IntegerMatrix incidence_matrix(const D0L& system);

/// How often each accessible letter occurs in the word of generation n, in the order of
/// `system.letters`; brackets are letters.
///
/// For few generations by iterating, otherwise by repeated squaring of the growth matrix,
/// O(letters^3 log n) products of exact integers. Throws BoundReached when the numbers would have
/// more digits than budget.letters, or take more than budget.memory.
///
/// Example: parikh_vector(d0l("b", {{'a', "ab"}, {'b', "a"}}), 5) == std::vector<Integer>{3, 5}
std::vector<Integer> parikh_vector(const D0L& system, std::uint64_t n, const Budget& budget = {});

/// About the binary logarithm of the length of the word of generation n, at once for any n: by
/// repeated squaring in floating point. Good to a few parts in 10^9; minus infinity for the empty
/// word. For deciding what to try, never for an answer.
double estimated_log2_length(const D0L& system, std::uint64_t n, const Budget& budget = {});

/// The length of the word of generation n. Throws BoundReached, at once, if it has more digits than
/// budget.letters.
///
/// Example: length(d0l("F", {{'F', "F+F--F+F"}}), 6) == 9556
Integer length(const D0L& system, std::uint64_t n, const Budget& budget = {});

}  // namespace algae
