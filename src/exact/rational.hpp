#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "exact/integer.hpp"

namespace algae {

/// A rational number in lowest terms, its denominator positive.
class Rational {
public:
    Rational() = default;
    Rational(Integer value) : numerator_(std::move(value)) {}
    template <std::integral T>
    Rational(T value) : numerator_(value) {}

    /// Throws `Error` if the denominator is 0.
    ///
    /// Example: Rational(6, -4) == Rational("-3/2")
    Rational(Integer numerator, Integer denominator);

    /// The number a person wrote: "7", "257/10", "25.7", "-0.5", ".5" or "1e-3", each exact.
    /// Throws `Error` on anything else, on a denominator 0, and on an exponent beyond 10000.
    ///
    /// Example: Rational("25.7") == Rational(257, 10)
    explicit Rational(std::string_view text);

    const Integer& numerator() const { return numerator_; }
    const Integer& denominator() const { return denominator_; }
    bool is_zero() const { return numerator_.is_zero(); }
    bool is_integer() const { return denominator_ == 1; }
    /// The nearest double, ties to even; infinite beyond the doubles.
    double to_double() const;

    Rational& operator+=(const Rational& right);
    Rational& operator-=(const Rational& right);
    Rational& operator*=(const Rational& right);
    /// Throws `Error` on a division by 0.
    Rational& operator/=(const Rational& right);

    friend Rational operator+(Rational left, const Rational& right) {
        return std::move(left += right);
    }
    friend Rational operator-(Rational left, const Rational& right) {
        return std::move(left -= right);
    }
    friend Rational operator*(Rational left, const Rational& right) {
        return std::move(left *= right);
    }
    friend Rational operator/(Rational left, const Rational& right) {
        return std::move(left /= right);
    }
    friend Rational operator-(Rational value) {
        value.numerator_.negate();
        return value;
    }

    friend bool operator==(const Rational&, const Rational&) = default;
    friend std::strong_ordering operator<=>(const Rational& left, const Rational& right);

    /// Throws `Error` on a negative power of 0, `BoundReached` if the result would be too long.
    ///
    /// Example: power(Rational(2, 3), -2) == Rational(9, 4)
    friend Rational power(const Rational& base, std::int64_t exponent);
    /// Example: abs(Rational(-1, 2)) == Rational(1, 2)
    friend Rational abs(Rational value);
    /// -1, 0 or 1.
    friend int sign(const Rational& value);
    /// "257/10", or "5" for an integer.
    ///
    /// Example: to_string(Rational("25.7")) == "257/10"
    friend std::string to_string(const Rational& value);
    friend std::size_t hash_value(const Rational& value);

private:
    friend struct FlintHandle;

    Integer numerator_;
    Integer denominator_ = 1;
};

/// The greatest integer that is not greater.
///
/// Example: floor(Rational(-7, 2)) == -4
Integer floor(const Rational& value);

/// The least integer that is not less.
///
/// Example: ceiling(Rational(7, 2)) == 4
Integer ceiling(const Rational& value);

/// The nearest integer; of two equally near ones, the even one.
///
/// Example: round_half_even(Rational(5, 2)) == 2
Integer round_half_even(const Rational& value);

std::ostream& operator<<(std::ostream& out, const Rational& value);

/// The number rounded to so many digits after the point, a tie going to the even last digit. What
/// rounds to zero has no sign. Throws `Error` unless 0 <= digits_after_point <= 10,000,000.
///
/// Example: decimal(Rational(-1, 8), 2) == "-0.12"
std::string decimal(const Rational& value, int digits_after_point);

/// The shortest decimal that is exactly the number, or nothing if there is none (1/3), or if it
/// has more than 10,000,000 digits after the point.
///
/// Example: exact_decimal(Rational(257, 10)) == "25.7"
std::optional<std::string> exact_decimal(const Rational& value);

}  // namespace algae

template <>
struct std::hash<algae::Rational> {
    std::size_t operator()(const algae::Rational& value) const { return hash_value(value); }
};
