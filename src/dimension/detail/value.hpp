#pragma once

// What algebraic integers are compared by.

#include "dimension/dimension.hpp"

namespace algae {

/// The matrix of multiplication by a root of a monic polynomial.
///
/// Example: companion(Polynomial({-1, -1, 1})) == IntegerMatrix({{0, 1}, {1, 1}})
IntegerMatrix companion(const Polynomial& polynomial);

/// By the characteristic polynomial of a power of the companion matrix. Throws BoundReached where
/// degree and exponent multiply to more than 400.
///
/// Example: power(*AlgebraicInteger::largest_root(Polynomial({-2, 0, 1})), 2).integer() == Integer(2)
AlgebraicInteger power(const AlgebraicInteger& base, unsigned exponent);

/// log left / log right, if powers of both with exponents of at most 24 are equal and right is not
/// 1; powers that `power` refuses are not compared.
///
/// Example: exponent_between(AlgebraicInteger(8), AlgebraicInteger(4)) == Rational(3, 2)
std::optional<Rational> exponent_between(const AlgebraicInteger& left,
                                         const AlgebraicInteger& right);

}  // namespace algae
