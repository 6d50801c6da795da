#pragma once

#include <concepts>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "exact/integer.hpp"
#include "exact/rational.hpp"

namespace algae {

/// A real number known to lie in an interval: midpoint plus or minus radius (Arb's `arb`). Every
/// operation gives an enclosure of all results its operands allow, at the larger of the operands'
/// precisions; where there is no real result for some of them (a division by an interval around 0,
/// a square root of a negative number) the enclosure is everything and `is_finite` is false.
class Ball {
public:
    /// An enclosure with about this many correct bits; 2 <= bits <= 2^30, or `Error` is thrown.
    ///
    /// Example: Ball(Rational(1, 3), 64).contains(Rational(1, 3))
    Ball(const Rational& value, long bits);
    Ball(const Integer& value, long bits);
    template <std::integral T>
    Ball(T value, long bits) : Ball(Integer(value), bits) {}
    Ball(const Ball& other);
    Ball(Ball&& other) noexcept;
    Ball& operator=(Ball other) noexcept;
    ~Ball();

    long bits() const { return bits_; }
    bool is_finite() const;
    bool contains(const Rational& value) const;
    bool contains(const Ball& inner) const;
    bool overlaps(const Ball& other) const;
    /// Whether the radius is at most 2^exponent.
    bool has_radius_below(long exponent) const;
    /// The only integer in the interval, if there is exactly one.
    std::optional<Integer> unique_integer() const;
    /// The nearest double of the midpoint: for pictures and progress, not for claims.
    double midpoint() const;
    /// The double that every number in the interval rounds to, if there is one.
    std::optional<double> unique_double() const;
    /// Exact ends of the interval. Throws `Error` if it is not finite, `BoundReached` if its numbers
    /// are too large or too small to be written out.
    Rational lower() const;
    Rational upper() const;

    Ball& operator+=(const Ball& right);
    Ball& operator-=(const Ball& right);
    Ball& operator*=(const Ball& right);
    Ball& operator/=(const Ball& right);
    friend Ball operator+(Ball left, const Ball& right) { return std::move(left += right); }
    friend Ball operator-(Ball left, const Ball& right) { return std::move(left -= right); }
    friend Ball operator*(Ball left, const Ball& right) { return std::move(left *= right); }
    friend Ball operator/(Ball left, const Ball& right) { return std::move(left /= right); }
    friend Ball operator-(Ball value);

private:
    friend struct BallHandle;  // exact/arb.hpp, for the .cpp files of this room
    struct Enclosure;

    std::unique_ptr<Enclosure> enclosure_;
    long bits_;
};

/// What two enclosures say for certain about the numbers in them.
enum class Order { less, equal, greater, unknown };

/// `equal` only if both are the same single point.
///
/// Example: compare(Ball(1, 64), sqrt(Ball(2, 64))) == Order::less
Order compare(const Ball& left, const Ball& right);

/// -1, 0 or 1 if all numbers in the interval have this sign, otherwise nothing.
std::optional<int> sign(const Ball& value);

Ball abs(const Ball& value);
Ball sqrt(const Ball& value);
Ball log(const Ball& value);
Ball exp(const Ball& value);
Ball power(const Ball& base, const Ball& exponent);
/// An enclosure of the circle number.
Ball pi(long bits);
/// The cosine and sine of pi times a rational.
///
/// Example: cos_pi(Rational(1, 3), 64).contains(Rational(1, 2))
Ball cos_pi(const Rational& value, long bits);
Ball sin_pi(const Rational& value, long bits);
/// The smallest ball around both.
Ball hull(const Ball& left, const Ball& right);

/// The number that `enclose(bits)` encloses ever more tightly as `bits` grows, rounded to so many
/// digits after the point. `enclose` is called with more and more bits until the answer is certain.
/// Throws `BoundReached` when `largest_bits` and 4 more for every digit do not suffice: the number
/// lies on, or extremely close to, the middle between two decimals, where only an exact form can say
/// more (use the `decimal` of a Rational).
///
/// Example: decimal([](long bits) { return sqrt(Ball(2, bits)); }, 5) == "1.41421"
std::string decimal(const std::function<Ball(long bits)>& enclose, int digits_after_point,
                    long largest_bits = 1L << 16);

/// The same to so many significant digits (at least 1); never in exponent notation. A number that
/// cannot be told from 0 is a `BoundReached`.
///
/// Example: significant_decimal([](long bits) { return exp(Ball(-5, bits)); }, 3) == "0.00674"
std::string significant_decimal(const std::function<Ball(long bits)>& enclose, int digits,
                                long largest_bits = 1L << 16);

/// "[1.41421 +/- 3.6e-6]", for messages and tests.
std::string to_string(const Ball& value);
std::ostream& operator<<(std::ostream& out, const Ball& value);

}  // namespace algae
