#pragma once

#include <optional>

#include "dimension/algebraic_integer.hpp"
#include "dimension/log_ratio.hpp"
#include "exact/ball.hpp"
#include "exact/rational.hpp"

namespace algae {

/// A number that dimensions are compared with: a rational one, or a rational multiple of
/// log a / log b.
class DimensionValue {
public:
    DimensionValue(const Rational& value) : factor_(value) {}
    /// factor * log over / log under, over at least 1 and under above 1.
    DimensionValue(const Rational& factor, const AlgebraicInteger& over,
                   const AlgebraicInteger& under);
    /// Nothing if the minimal polynomial of |mu|^2 is not known.
    static std::optional<DimensionValue> of(const LogRatio& ratio);

    /// The number itself, if powers of a and b are found to be equal.
    std::optional<Rational> rational() const;
    Ball enclosure(long bits) const;

private:
    friend Order compare(const DimensionValue& left, const DimensionValue& right);

    Rational factor_;
    std::optional<AlgebraicInteger> over_, under_;
};

/// How digits of both have to agree before two values are not said to be different.
inline constexpr int digits_compared = 200;

/// Exactly where they are equal: two rational numbers, or powers of a and a', and of b and b', that
/// are equal with matching exponents; less or greater where enclosures differ. `unknown` if they agree
/// in 200 digits and there is no such proof. That log a / log b = log a' / log b' needs powers that
/// are equal is not known in general (it follows from Schanuel's conjecture).
///
/// Example: compare(DimensionValue(Rational(1), AlgebraicInteger(8), AlgebraicInteger(4)), Rational(3, 2)) == Order::equal
Order compare(const DimensionValue& left, const DimensionValue& right);

/// The same where the first value may be known by enclosures only.
Order compare(const LogRatio& left, const DimensionValue& right);

}  // namespace algae
