#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "exact/rational.hpp"
#include "system/expression.hpp"

namespace algae {

/// A function of n that is a sum of terms c n^k r^n with rational c and r.
struct ExponentialPolynomial {
    std::map<Rational, std::vector<Rational>> terms;  // by r: the coefficients of n^0, n^1, ...

    Rational operator()(std::uint64_t n) const;
    /// The order of a linear recurrence that it satisfies.
    std::size_t order() const;
};

/// The function that an expression in n says: made by + - *, division by constants and powers with a number
/// as exponent or with a number as base and an exponent like 2n+1. Throws Error for anything else.
///
/// Example: exponential_polynomial(parsed("2^n+n"))(3) == Rational(11)
ExponentialPolynomial exponential_polynomial(const Expression& expression);

}  // namespace algae
