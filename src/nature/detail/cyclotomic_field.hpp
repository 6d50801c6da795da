#pragma once

// Exact numbers of the plane: the field of the rational numbers and a root of unity. Positions and
// turns by rational numbers of degrees, and square roots of rational numbers, lie in one.

#include <complex>

#include "exact/exact.hpp"
#include "system/system.hpp"

namespace algae {

/// above / below, in lowest terms, so that equal numbers have equal members.
struct CyclotomicNumber {
    CyclotomicInteger above;
    Integer below = 1;

    bool operator==(const CyclotomicNumber&) const = default;
};

/// The field Q(zeta_m). Elements handed to it must be its own; this is not checked.
class CyclotomicField {
public:
    /// Throws `Error` unless 1 <= order <= CyclotomicRing::largest_order.
    explicit CyclotomicField(long order) : ring_(order) {}

    long order() const { return ring_.order(); }
    std::size_t degree() const { return ring_.degree(); }

    CyclotomicNumber rational(const Rational& value) const;
    /// zeta^exponent.
    CyclotomicNumber zeta(std::int64_t exponent) const;
    /// e^(i degrees), if it lies in the field.
    std::optional<CyclotomicNumber> direction(const Rational& degrees) const;
    /// The square root that is not negative, or a positive multiple of i; nothing if it does not lie
    /// in the field, or is not seen to.
    std::optional<CyclotomicNumber> square_root(const Rational& value) const;
    /// The value of an expression without names: of rational numbers, + - * /, integral powers,
    /// square roots of what is rational, sines, cosines and tangents of rational degrees. Nothing
    /// if some part of it is of another kind or lies outside the field.
    std::optional<CyclotomicNumber> value_of(const Expression& constant) const;

    CyclotomicNumber sum(const CyclotomicNumber& left, const CyclotomicNumber& right) const;
    CyclotomicNumber difference(const CyclotomicNumber& left, const CyclotomicNumber& right) const;
    CyclotomicNumber product(const CyclotomicNumber& left, const CyclotomicNumber& right) const;
    CyclotomicNumber conjugate(const CyclotomicNumber& value) const;
    /// Throws Error for 0.
    CyclotomicNumber inverse(const CyclotomicNumber& value) const;
    bool is_zero(const CyclotomicNumber& value) const;
    /// The number, if it is rational.
    std::optional<Rational> as_rational(const CyclotomicNumber& value) const;
    /// Within about 1e-15 of its size.
    std::complex<double> to_complex(const CyclotomicNumber& value) const;
    /// How two real numbers compare.
    std::weak_ordering compare(const CyclotomicNumber& left, const CyclotomicNumber& right) const;

private:
    CyclotomicNumber lowest(CyclotomicInteger above, Integer below) const;

    CyclotomicRing ring_;
};

/// The least m, a multiple of 4, such that Q(zeta_m) has the values of all these expressions; of what
/// `CyclotomicField::value_of` does not know, nothing is asked. Nothing beyond the largest order.
///
/// Example: (void)0, cyclotomic_order({}) == 4
std::optional<long> cyclotomic_order(const std::vector<const Expression*>& constants);

}  // namespace algae
