#pragma once

#include <string>

#include "exact/ball.hpp"
#include "exact/integer.hpp"
#include "exact/polynomial.hpp"
#include "exact/rational.hpp"

namespace algae {

/// rational + factor * sqrt(radicand), the radicand a squarefree integer other than 0 and 1, or
/// negative: then the number is complex.
struct QuadraticNumber {
    Rational rational;
    Rational factor;
    Integer radicand = 1;

    /// The same with the other sign before the root.
    QuadraticNumber conjugate() const { return {rational, -factor, radicand}; }
    bool is_complex() const { return sign(radicand) < 0 && !factor.is_zero(); }
    bool operator==(const QuadraticNumber&) const = default;
};

/// The root with the positive sign before the square root of an irreducible polynomial of degree 2.
///
/// Example: to_string(larger_root(Polynomial({-1, -1, 1}))) == "(1+sqrt(5))/2"
QuadraticNumber larger_root(const Polynomial& irreducible);

/// first + second * number.
QuadraticNumber combination(const Rational& first, const Rational& second, const QuadraticNumber& number);

/// "(5+3*sqrt(5))/10", "2*sqrt(2)", "(-1+i*sqrt(3))/2", "i", "3/2".
std::string to_string(const QuadraticNumber& number);

}  // namespace algae
