#pragma once

#include <cstddef>
#include <vector>

#include "exact/polynomial.hpp"

namespace algae {

/// A quotient p(r)/q(r) of integer polynomials in a root r of a monic irreducible polynomial; where
/// the denominator is an integer, the number is a polynomial in r with rational coefficients.
struct AlgebraicNumber {
    Polynomial numerator;
    Polynomial denominator = 1;
    bool operator==(const AlgebraicNumber&) const = default;
};

/// The ring Z[r] for a root r of a monic irreducible polynomial. Elements are polynomials of smaller degree.
class NumberField {
public:
    explicit NumberField(Polynomial modulus) : modulus_(std::move(modulus)) {}

    const Polynomial& modulus() const { return modulus_; }
    Polynomial reduced(const Polynomial& value) const { return remainder(value, modulus_); }
    Polynomial multiply(const Polynomial& left, const Polynomial& right) const { return reduced(left * right); }
    Polynomial power(Polynomial base, std::size_t exponent) const;
    /// The quotient with an integer as its denominator, positive and in lowest terms: multiplies
    /// by the other conjugates of the denominator, which Cayley and Hamilton give. For small degrees:
    /// the numbers grow.
    ///
    /// Example: NumberField(Polynomial({-2, 0, 1})).simplified({1, Polynomial({0, 1})}) == AlgebraicNumber{Polynomial({0, 1}), 2}
    AlgebraicNumber simplified(const AlgebraicNumber& value) const;

private:
    Polynomial modulus_;
};

}  // namespace algae
