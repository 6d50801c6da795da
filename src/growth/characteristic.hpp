#pragma once

#include "base/budget.hpp"
#include "exact/polynomial.hpp"
#include "growth/components.hpp"
#include "growth/growth_matrix.hpp"

namespace algae {

/// det(x - matrix) and the monic polynomial of least degree that the matrix is a root of, with the
/// irreducible factors of both.
struct MatrixPolynomials {
    Polynomial characteristic;
    Polynomial minimal;
    Factorisation characteristic_factors;
    Factorisation minimal_factors;
};

/// From the characteristic polynomials of the components. Where the nonzero roots are simple, the
/// minimal polynomial needs ranks of powers of the matrix only, otherwise FLINT's elimination.
///
/// Example: matrix_polynomials(growth_matrix(d0l("F", {{'F', "F+F--F+F"}}))).minimal == Polynomial({4, -5, 1})
MatrixPolynomials matrix_polynomials(const GrowthMatrix& matrix, const Budget& budget = {});
MatrixPolynomials matrix_polynomials(const GrowthMatrix& matrix, const Components& components,
                                     const Budget& budget = {});

/// det(x - matrix): by FLINT for small matrices; for large ones, which have few entries in a row, by
/// the annihilator of a random vector, and Newton's identities for what it leaves.
Polynomial characteristic_polynomial(const GrowthMatrix& matrix, const Budget& budget = {});

}  // namespace algae
