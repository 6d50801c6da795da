#pragma once

#include <map>
#include <vector>

#include "exact/rational.hpp"
#include "verify/field.hpp"

namespace algae::verify {

/// A function of n that is a sum of polynomials in n times powers b^n, exactly; 0^0 is 1.
class ExponentialPolynomial {
public:
    ExponentialPolynomial() = default;

    /// The function that a formula gives: numbers, n, + - * / ^ and brackets; ^ binds tightest and to the
    /// right. Throws Error at `field` if it cannot be read, BoundReached if it is no such function, or too large.
    static ExponentialPolynomial read(const Field& field);
    /// The sum of the terms that a proof lists: {"coefficient", "power", "base"} each.
    static ExponentialPolynomial read_terms(const Field& field);

    Rational operator()(std::uint64_t n) const;
    /// The order of the linear recurrence that it obeys.
    std::size_t order() const;

    bool operator==(const ExponentialPolynomial&) const = default;

private:
    friend class FormulaReader;
    using Coefficients = std::vector<Rational>;  // of 1, n, n^2, ...

    static ExponentialPolynomial constant(const Rational& value);
    static ExponentialPolynomial raised(const ExponentialPolynomial& base,
                                        const ExponentialPolynomial& exponent, const Field& field);
    /// The inverse, of a constant times a power b^n. Throws BoundReached if it is something else.
    ExponentialPolynomial inverse(const Field& field) const;
    const Rational* as_constant() const;
    void add(const ExponentialPolynomial& other, const Rational& factor);
    ExponentialPolynomial times(const ExponentialPolynomial& other) const;
    void settle();
    /// Throws BoundReached where it has grown too large.
    void check_size(const Field& field) const;

    std::map<Rational, Coefficients> terms_;  // by base; no polynomial is zero
};

}  // namespace algae::verify
