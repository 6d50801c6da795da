#pragma once

#include <compare>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "exact/ball.hpp"
#include "exact/integer.hpp"
#include "exact/rational.hpp"

namespace algae {

/// An element of Z[zeta_m]: its coordinates in the basis 1, zeta, ..., zeta^(phi(m)-1). Coordinates
/// are unique, so equality of coordinates is equality of numbers. The ring is not stored with it.
struct CyclotomicInteger {
    std::vector<Integer> coefficients;

    bool operator==(const CyclotomicInteger&) const = default;
};

/// The ring Z[zeta_m] with zeta_m = exp(2 pi i / m): where a turtle that turns by multiples of
/// 360/m degrees and walks in whole steps can be. Cheap to copy; safe to use from several threads.
/// Elements handed to it must have `degree()` coordinates; this is not checked.
class CyclotomicRing {
public:
    static constexpr long largest_order = 3600;

    /// Throws `Error` unless 1 <= order <= `largest_order`.
    explicit CyclotomicRing(long order);

    /// m.
    long order() const;
    /// phi(m), the number of coordinates.
    std::size_t degree() const;
    friend bool operator==(const CyclotomicRing& left, const CyclotomicRing& right) {
        return left.order() == right.order();
    }

    CyclotomicInteger zero() const;
    CyclotomicInteger one() const;
    CyclotomicInteger integer(const Integer& value) const;
    /// zeta^exponent, for any exponent, also negative.
    ///
    /// Example: CyclotomicRing(6).zeta(3) == CyclotomicRing(6).integer(-1)
    CyclotomicInteger zeta(std::int64_t exponent) const;
    /// The coordinates of zeta^exponent as machine numbers. They are small: for m up to 3600 they
    /// are at most 18 in size. The table behind it is built at the first call (m * phi(m) numbers).
    std::span<const std::int64_t> power(std::int64_t exponent) const;

    /// left += right and so on, in place.
    void add(CyclotomicInteger& left, const CyclotomicInteger& right) const;
    void subtract(CyclotomicInteger& left, const CyclotomicInteger& right) const;
    void negate(CyclotomicInteger& value) const;
    void scale(CyclotomicInteger& value, const Integer& factor) const;
    /// left += zeta^exponent * right: one step of a turtle's product, without temporaries.
    void add_rotated(CyclotomicInteger& left, const CyclotomicInteger& right,
                     std::int64_t exponent) const;

    /// zeta^exponent * value. At most phi(m) * phi(r) additions, r the product of the primes in m.
    CyclotomicInteger rotate(const CyclotomicInteger& value, std::int64_t exponent) const;
    CyclotomicInteger multiply(const CyclotomicInteger& left, const CyclotomicInteger& right) const;
    /// The complex conjugate: zeta becomes 1/zeta.
    CyclotomicInteger conjugate(const CyclotomicInteger& value) const;

    /// The exact sign, -1, 0 or 1, of the real part: floating point with an error bound first, then
    /// the exact question whether value + conjugate is 0, then enclosures of rising precision.
    int real_part_sign(const CyclotomicInteger& value) const;
    int imaginary_part_sign(const CyclotomicInteger& value) const;
    /// How the real parts compare, exactly.
    std::weak_ordering compare_real(const CyclotomicInteger& left,
                                    const CyclotomicInteger& right) const;
    std::weak_ordering compare_imaginary(const CyclotomicInteger& left,
                                         const CyclotomicInteger& right) const;
    /// Which of two points lies farther in the direction of zeta^exponent: compares the real parts
    /// of zeta^-exponent times each, exactly and without rotating them.
    std::weak_ordering compare_along(const CyclotomicInteger& left, const CyclotomicInteger& right,
                                     std::int64_t exponent) const;

    /// Real and imaginary part, each the nearest double.
    std::complex<double> to_complex(const CyclotomicInteger& value) const;
    /// The same for coordinates held as machine numbers.
    std::complex<double> to_complex(std::span<const std::int64_t> coordinates) const;
    /// Enclosures of the real and the imaginary part.
    Ball real_part(const CyclotomicInteger& value, long bits) const;
    Ball imaginary_part(const CyclotomicInteger& value, long bits) const;
    /// The real part if it is rational. (It is then half an integer.)
    ///
    /// Example: CyclotomicRing(6).real_rational(CyclotomicRing(6).zeta(1)) == Rational(1, 2)
    std::optional<Rational> real_rational(const CyclotomicInteger& value) const;
    std::optional<Rational> imaginary_rational(const CyclotomicInteger& value) const;
    /// factor times the real part, correctly rounded to so many digits after the point.
    ///
    /// Example: CyclotomicRing(8).real_decimal(CyclotomicRing(8).zeta(1), 4) == "0.7071"
    std::string real_decimal(const CyclotomicInteger& value, int digits_after_point,
                             const Rational& factor = 1) const;
    std::string imaginary_decimal(const CyclotomicInteger& value, int digits_after_point,
                                  const Rational& factor = 1) const;

private:
    struct Context;
    std::shared_ptr<const Context> context_;
};

std::size_t hash_value(const CyclotomicInteger& value);

}  // namespace algae

template <>
struct std::hash<algae::CyclotomicInteger> {
    std::size_t operator()(const algae::CyclotomicInteger& value) const {
        return hash_value(value);
    }
};
