#pragma once

#include <compare>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exact/ball.hpp"
#include "exact/polynomial.hpp"

namespace algae {

/// A rate of growth: a positive algebraic integer that is the largest real root of its minimal
/// polynomial and in size at least as large as all its other roots, as the theorem of Perron and
/// Frobenius says of the spectral radius of a matrix of natural numbers. So two rates are equal
/// exactly if their minimal polynomials are.
class Rate {
public:
    /// A natural number.
    Rate(const Integer& value = 1);
    /// The largest real root of a monic irreducible polynomial, which is below `above`. That it is
    /// a rate is not checked.
    Rate(Polynomial minimal_polynomial, Rational above);

    const Polynomial& minimal_polynomial() const { return minimal_; }
    long degree() const { return minimal_.degree(); }
    /// The number itself, if it is rational; it is then an integer.
    std::optional<Integer> integer() const;
    /// An enclosure with a radius of at most 2^-bits. By Newton's method from above, which
    /// converges because no derivative has a root beyond the largest one (Gauss and Lucas).
    Ball enclosure(long bits) const;

    /// "2", "(1+sqrt(5))/2", "2^(1/3)", "((3+sqrt(5))/2)^(1/2)", otherwise "the largest real root of x^3 - x - 1".
    ///
    /// Example: Rate(Polynomial({-1, -1, 1}), 2).exact() == "(1+sqrt(5))/2"
    std::string exact() const;
    /// Correctly rounded to so many significant digits, without zeros behind the point of an integer.
    ///
    /// Example: Rate(Polynomial({-1, -1, 1}), 2).decimal(5) == "1.6180"
    std::string decimal(int digits) const;

    friend bool operator==(const Rate& left, const Rate& right) { return left.minimal_ == right.minimal_; }
    friend std::strong_ordering operator<=>(const Rate& left, const Rate& right);

private:
    Polynomial minimal_;
    Rational above_;
};

/// The largest real root of a squarefree monic polynomial none of whose roots is larger in size,
/// between two rationals at most 2^-bits apart. `above` is an upper bound.
std::pair<Rational, Rational> largest_root(const Polynomial& value, const Rational& above, long bits);

/// The spectral radius of an irreducible matrix with this characteristic polynomial, which is not a
/// power of x, below `above`: found among the irreducible factors given, exactly.
Rate spectral_radius(const std::vector<Factorisation::Power>& factors, const Rational& above);

std::ostream& operator<<(std::ostream& out, const Rate& rate);

}  // namespace algae
