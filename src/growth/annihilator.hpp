#pragma once

#include <vector>

#include "base/budget.hpp"
#include "exact/polynomial.hpp"
#include "growth/growth_matrix.hpp"

namespace algae {

/// Whether row * p(matrix) * matrix^n * column == 0 for all n, exactly: the first `matrix.size()`
/// of these numbers decide, by the theorem of Cayley and Hamilton.
bool annihilates(const Polynomial& p, const std::vector<Integer>& row, const GrowthMatrix& matrix,
                 const std::vector<Integer>& column, const Budget& budget = {});

/// The monic polynomial of least degree that annihilates the sequence row * matrix^n * column. Its
/// coefficients are integers (it divides the characteristic polynomial; Gauss's lemma).
///
/// The algorithm of Berlekamp and Massey modulo primes below 2^61, put together until the result
/// stands, which is then proved by `annihilates`; its degree is the least because no prime can ask
/// for a longer recurrence than the integers do. O(size^2) operations for each prime.
Polynomial annihilator(const std::vector<Integer>& row, const GrowthMatrix& matrix,
                       const std::vector<Integer>& column, const Budget& budget = {});

/// The monic polynomial m of least degree with row * m(matrix) == 0.
Polynomial annihilator(const std::vector<Integer>& row, const GrowthMatrix& matrix, const Budget& budget = {});

}  // namespace algae
