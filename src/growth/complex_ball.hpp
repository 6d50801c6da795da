#pragma once

#include <cstdint>

#include "exact/ball.hpp"
#include "exact/polynomial.hpp"

namespace algae {

/// A complex number known to lie in a rectangle.
struct ComplexBall {
    Ball real;
    Ball imaginary;

    friend ComplexBall operator+(const ComplexBall& a, const ComplexBall& b) {
        return {a.real + b.real, a.imaginary + b.imaginary};
    }
    friend ComplexBall operator*(const ComplexBall& a, const ComplexBall& b) {
        return {a.real * b.real - a.imaginary * b.imaginary, a.real * b.imaginary + a.imaginary * b.real};
    }
    friend ComplexBall operator/(const ComplexBall& a, const ComplexBall& b) {
        const Ball size = b.real * b.real + b.imaginary * b.imaginary;
        const ComplexBall product = a * ComplexBall{b.real, -b.imaginary};
        return {product.real / size, product.imaginary / size};
    }
    bool contains_zero() const { return real.contains(Rational(0)) && imaginary.contains(Rational(0)); }
};

inline ComplexBall power(ComplexBall base, std::uint64_t exponent) {
    ComplexBall result{Ball(1, base.real.bits()), Ball(0, base.real.bits())};
    for (; exponent != 0; exponent >>= 1) {
        if (exponent & 1) result = result * base;
        if (exponent > 1) base = base * base;
    }
    return result;
}

/// Horner's rule.
inline ComplexBall value_at(const Polynomial& polynomial, const ComplexBall& x) {
    const long bits = x.real.bits();
    ComplexBall result{Ball(0, bits), Ball(0, bits)};
    for (std::size_t k = polynomial.coefficients().size(); k-- > 0;)
        result = result * x + ComplexBall{Ball(polynomial.coefficients()[k], bits), Ball(0, bits)};
    return result;
}

}  // namespace algae
