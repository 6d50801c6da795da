#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exact/ball.hpp"
#include "exact/integer.hpp"
#include "exact/integer_matrix.hpp"
#include "exact/rational.hpp"

namespace algae {

/// A polynomial in one variable with integer coefficients.
class Polynomial {
public:
    Polynomial() = default;
    Polynomial(const Integer& constant);
    template <std::integral T>
    Polynomial(T constant) : Polynomial(Integer(constant)) {}
    /// Coefficients from the constant one upwards; zeros at the end are dropped.
    ///
    /// Example: to_string(Polynomial({-1, -1, 1})) == "x^2 - x - 1"
    explicit Polynomial(std::vector<Integer> coefficients);
    explicit Polynomial(std::initializer_list<Integer> coefficients)
        : Polynomial(std::vector<Integer>(coefficients)) {}
    /// coefficient * x^exponent.
    static Polynomial monomial(const Integer& coefficient, std::size_t exponent);

    /// -1 for the zero polynomial.
    long degree() const { return static_cast<long>(coefficients_.size()) - 1; }
    bool is_zero() const { return coefficients_.empty(); }
    /// 0 beyond the degree.
    Integer coefficient(std::size_t exponent) const {
        return exponent < coefficients_.size() ? coefficients_[exponent] : Integer();
    }
    const std::vector<Integer>& coefficients() const { return coefficients_; }
    /// 0 for the zero polynomial.
    Integer leading_coefficient() const {
        return coefficients_.empty() ? Integer() : coefficients_.back();
    }

    Polynomial& operator+=(const Polynomial& right);
    Polynomial& operator-=(const Polynomial& right);
    Polynomial& operator*=(const Polynomial& right);
    friend Polynomial operator+(Polynomial left, const Polynomial& right) {
        return std::move(left += right);
    }
    friend Polynomial operator-(Polynomial left, const Polynomial& right) {
        return std::move(left -= right);
    }
    friend Polynomial operator*(Polynomial left, const Polynomial& right) {
        return std::move(left *= right);
    }
    friend Polynomial operator-(Polynomial value);
    friend bool operator==(const Polynomial&, const Polynomial&) = default;

    Integer operator()(const Integer& x) const;
    Rational operator()(const Rational& x) const;
    Ball operator()(const Ball& x) const;

    /// Throws `BoundReached` if the result would be too long.
    friend Polynomial power(const Polynomial& base, std::uint64_t exponent);
    /// The greatest common divisor over the integers, leading coefficient not negative.
    ///
    /// Example: gcd(Polynomial({-1, 0, 1}), Polynomial({1, 2, 1})) == Polynomial({1, 1})
    friend Polynomial gcd(const Polynomial& left, const Polynomial& right);
    /// dividend / divisor if it is a polynomial with integer coefficients. Throws `Error` on 0.
    friend std::optional<Polynomial> exact_divide(const Polynomial& dividend,
                                                  const Polynomial& divisor);
    /// The remainder modulo a polynomial whose leading coefficient is 1 or -1; otherwise throws `Error`.
    friend Polynomial remainder(const Polynomial& dividend, const Polynomial& divisor);

private:
    friend struct FlintHandle;
    void drop_leading_zeros();

    std::vector<Integer> coefficients_;  // the last one is not 0
};

Polynomial derivative(const Polynomial& value);
/// The coefficients in the opposite order: x^degree p(1/x).
Polynomial reversed(const Polynomial& value);
/// The greatest common divisor of the coefficients, not negative.
Integer content(const Polynomial& value);
/// The polynomial over its content, leading coefficient positive; 0 for 0.
Polynomial primitive_part(const Polynomial& value);
/// Whether no factor of positive degree occurs twice.
bool is_squarefree(const Polynomial& value);

/// unit_and_content times the product of the factors, each irreducible over the rationals, primitive,
/// with a positive leading coefficient; in order of degree, then of coefficients from the top.
struct Factorisation {
    struct Power {
        Polynomial factor;
        unsigned exponent;
        bool operator==(const Power&) const = default;
    };
    Integer content;
    std::vector<Power> powers;
};

/// Throws `Error` on the zero polynomial. Van Hoeij's algorithm (FLINT).
///
/// Example: factorise(Polynomial({-2, 0, 2})).powers.size() == 2
Factorisation factorise(const Polynomial& value);

/// The minimal polynomial of exp(2 pi i / order). Throws `Error` unless 1 <= order <= 1,000,000.
///
/// Example: cyclotomic_polynomial(6) == Polynomial({1, -1, 1})
Polynomial cyclotomic_polynomial(long order);
/// The order of the roots of unity whose minimal polynomial this is, or nothing.
std::optional<unsigned long> cyclotomic_order(const Polynomial& value);

/// A root of a polynomial: enclosures of its real and imaginary part, and how often it occurs.
struct Root {
    Ball real;
    Ball imaginary;
    unsigned multiplicity;
    bool is_real;  // proved; then `imaginary` is exactly 0
};

/// All complex roots, isolated from each other, each enclosed to at least `bits` bits. Throws
/// `Error` on the zero polynomial.
std::vector<Root> roots(const Polynomial& value, long bits);

/// det(x - matrix). Throws `Error` if the matrix is not square.
///
/// Example: characteristic_polynomial(IntegerMatrix({{1, 1}, {1, 0}})) == Polynomial({-1, -1, 1})
Polynomial characteristic_polynomial(const IntegerMatrix& matrix);
/// The monic polynomial of least degree that the matrix is a root of. Throws `Error` if the matrix
/// is not square.
Polynomial minimal_polynomial(const IntegerMatrix& matrix);

/// "x^2 - x - 1".
std::string to_string(const Polynomial& value, const std::string& variable = "x");
std::ostream& operator<<(std::ostream& out, const Polynomial& value);

}  // namespace algae
