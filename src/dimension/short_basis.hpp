#pragma once

#include <functional>
#include <vector>

#include "base/budget.hpp"
#include "dimension/leading_factor.hpp"
#include "exact/integer_matrix.hpp"
#include "exact/polynomial.hpp"
#include "growth/complex_ball.hpp"

namespace algae {

/// The complex numbers that the rows of a basis stand for, for each of some roots of an irreducible
/// polynomial: with relative errors below 2^-digits. Rows are coordinates c A^i u of a number c (see
/// LeadingFactor). `roots` gives the roots to so many bits. Throws BoundReached where that takes
/// too many bits.
std::vector<std::vector<ComplexBall>> numbers_of(
    const IntegerMatrix& basis, const Polynomial& factor,
    const std::function<std::vector<ComplexBall>(long)>& roots, long digits, const Budget& budget);

/// A basis of the same lattice whose elements are small with all roots of the factor, so that mu
/// and zeta have small matrices in it: by the algorithm of Lenstra, Lenstra and Lovasz (1982). Throws
/// BoundReached where that takes too many digits.
IntegerMatrix short_basis(IntegerMatrix basis, const LeadingFactor& leading, const Budget& budget);

}  // namespace algae
