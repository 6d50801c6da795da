#include "exact/exact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>

#include "exact/detail/flint.hpp"

namespace algae {

namespace {

constexpr int most_digits = 10'000'000;
constexpr std::int64_t largest_exponent = 10'000;

[[noreturn]] void refuse(std::string_view text) {
    throw Error("expected a number such as 7, 257/10, 25.7 or 1e-3, found \"" +
                (text.size() <= 60 ? std::string(text) : std::string(text.substr(0, 57)) + "...") +
                "\"");
}

bool is_digits(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The exponent behind an e: a sign, digits.
std::int64_t read_exponent(std::string_view exponent, std::string_view text) {
    const bool negative = exponent.starts_with('-');
    if (negative || exponent.starts_with('+')) exponent.remove_prefix(1);
    if (!is_digits(exponent)) refuse(text);
    const Integer size(exponent);
    if (size > largest_exponent)
        throw Error("expected an exponent of at most 10000, found " +
                    std::string(exponent.substr(0, 40)));
    return negative ? -size.to_int64() : size.to_int64();
}

Rational read_decimal(std::string_view number, std::string_view text) {
    std::int64_t exponent = 0;
    if (const auto e = number.find_first_of("eE"); e != std::string_view::npos) {
        exponent = read_exponent(number.substr(e + 1), text);
        number = number.substr(0, e);
    }
    std::string digits(number);
    if (const auto point = number.find('.'); point != std::string_view::npos) {
        const std::string_view after = number.substr(point + 1);
        if (!is_digits(after) || !(point == 0 || is_digits(number.substr(0, point)))) refuse(text);
        digits = std::string(number.substr(0, point)) + std::string(after);
        exponent -= static_cast<std::int64_t>(after.size());
    }
    if (!is_digits(digits)) refuse(text);
    const Integer tens = power(Integer(10), static_cast<std::uint64_t>(std::abs(exponent)));
    return exponent < 0 ? Rational(Integer(digits), tens) : Rational(Integer(digits) * tens);
}

/// The nearest integer to numerator / denominator, ties to even; denominator positive.
Integer round_quotient(const Integer& numerator, const Integer& denominator) {
    Integer quotient = floor_divide(numerator, denominator);
    const auto order = (numerator - quotient * denominator) * 2 <=> denominator;
    if (order > 0 || (order == 0 && !quotient.is_even())) quotient += 1;
    return quotient;
}

/// The digits of `scaled` with a point before the last `after_point` of them.
std::string place_point(const Integer& scaled, int after_point) {
    std::string digits = to_string(abs(scaled));
    const auto places = static_cast<std::size_t>(after_point);
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    if (places > 0) digits.insert(digits.size() - places, 1, '.');
    return sign(scaled) < 0 ? '-' + digits : digits;
}

}  // namespace

Rational::Rational(Integer numerator, Integer denominator)
    : numerator_(std::move(numerator)), denominator_(std::move(denominator)) {
    if (denominator_.is_zero()) throw Error("expected a denominator other than 0, found 0");
    if (sign(denominator_) < 0) {
        numerator_.negate();
        denominator_.negate();
    }
    if (denominator_ == 1) return;
    const Integer common = gcd(numerator_, denominator_);
    if (common == 1) return;
    numerator_ = exact_divide(numerator_, common);
    denominator_ = exact_divide(denominator_, common);
}

Rational::Rational(std::string_view text) {
    std::string_view number = text;
    const bool negative = number.starts_with('-');
    if (negative || number.starts_with('+')) number.remove_prefix(1);
    if (const auto slash = number.find('/'); slash != std::string_view::npos) {
        if (!is_digits(number.substr(0, slash)) || !is_digits(number.substr(slash + 1)))
            refuse(text);
        *this = Rational(Integer(number.substr(0, slash)), Integer(number.substr(slash + 1)));
    } else {
        *this = read_decimal(number, text);
    }
    if (negative) numerator_.negate();
}

Rational& Rational::operator+=(const Rational& right) {
    if (is_integer() && right.is_integer())
        numerator_ += right.numerator_;
    else
        _fmpq_add(flint(numerator_), flint(denominator_), flint(numerator_), flint(denominator_),
                  flint(right.numerator_), flint(right.denominator_));
    return *this;
}

Rational& Rational::operator-=(const Rational& right) {
    if (is_integer() && right.is_integer())
        numerator_ -= right.numerator_;
    else
        _fmpq_sub(flint(numerator_), flint(denominator_), flint(numerator_), flint(denominator_),
                  flint(right.numerator_), flint(right.denominator_));
    return *this;
}

Rational& Rational::operator*=(const Rational& right) {
    // Cancelling crosswise first keeps the numbers short and the result in lowest terms.
    const Integer first = gcd(numerator_, right.denominator_);
    const Integer second = gcd(right.numerator_, denominator_);
    if (first.is_zero() || second.is_zero()) return *this = Rational();
    Integer top = exact_divide(numerator_, first) * exact_divide(right.numerator_, second);
    denominator_ = exact_divide(denominator_, second) * exact_divide(right.denominator_, first);
    numerator_ = std::move(top);
    return *this;
}

Rational& Rational::operator/=(const Rational& right) {
    if (right.is_zero()) throw Error("expected a divisor other than 0, found 0");
    Rational inverse;
    inverse.numerator_ = right.denominator_;
    inverse.denominator_ = right.numerator_;
    if (sign(inverse.denominator_) < 0) {
        inverse.numerator_.negate();
        inverse.denominator_.negate();
    }
    return *this *= inverse;
}

std::strong_ordering operator<=>(const Rational& left, const Rational& right) {
    if (left.denominator_ == right.denominator_) return left.numerator_ <=> right.numerator_;
    return _fmpq_cmp(flint(left.numerator_), flint(left.denominator_), flint(right.numerator_),
                     flint(right.denominator_)) <=> 0;
}

Rational exactly(double value) {
    if (!std::isfinite(value)) throw Error("expected a finite number");
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    const Rational mantissa(static_cast<std::int64_t>(std::ldexp(fraction, 53)));
    return mantissa * power(Rational(2), exponent - 53);
}

double Rational::to_double() const {
    if (is_zero()) return 0;
    // The result is a 53-bit integer times 2^exponent, or fewer bits at the smallest exponent.
    const auto difference = static_cast<std::int64_t>(bit_length(numerator_)) -
                            static_cast<std::int64_t>(bit_length(denominator_));
    if (difference > 1025) return sign(numerator_) < 0 ? -HUGE_VAL : HUGE_VAL;
    if (difference < -1100) return sign(numerator_) < 0 ? -0.0 : 0.0;
    const auto scaled_to = [this](std::int64_t exponent) {
        const Integer scale =
            algae::power(Integer(2), static_cast<std::uint64_t>(std::abs(exponent)));
        return exponent < 0 ? round_quotient(abs(numerator_) * scale, denominator_)
                            : round_quotient(abs(numerator_), denominator_ * scale);
    };
    // The quotient lies between 2^(difference-1) and 2^(difference+1).
    std::int64_t exponent = std::max<std::int64_t>(difference - 53, -1074);
    Integer mantissa = scaled_to(exponent);
    if (bit_length(mantissa) > 53) mantissa = scaled_to(++exponent);
    const double result = std::ldexp(mantissa.to_double(), static_cast<int>(exponent));
    return sign(numerator_) < 0 ? -result : result;
}

Integer floor(const Rational& value) {
    return floor_divide(value.numerator(), value.denominator());
}

Integer ceiling(const Rational& value) { return -floor(-value); }

Integer round_half_even(const Rational& value) {
    return round_quotient(value.numerator(), value.denominator());
}

Rational power(const Rational& base, std::int64_t exponent) {
    const std::uint64_t size = exponent < 0 ? 0 - static_cast<std::uint64_t>(exponent)
                                            : static_cast<std::uint64_t>(exponent);
    if (exponent < 0 && base.is_zero())
        throw Error("expected a base other than 0 for a negative power, found 0");
    Rational result;
    FlintHandle::numerator(result) = power(base.numerator(), size);
    FlintHandle::denominator(result) = power(base.denominator(), size);
    return exponent < 0 ? 1 / result : result;
}

Rational abs(Rational value) { return sign(value) < 0 ? -std::move(value) : value; }

int sign(const Rational& value) { return sign(value.numerator()); }

std::string to_string(const Rational& value) {
    if (value.is_integer()) return to_string(value.numerator());
    return to_string(value.numerator()) + '/' + to_string(value.denominator());
}

std::ostream& operator<<(std::ostream& out, const Rational& value) {
    return out << to_string(value);
}

std::string decimal(const Rational& value, int digits_after_point) {
    if (digits_after_point < 0 || digits_after_point > most_digits)
        throw Error("expected 0 to 10000000 digits after the point, found " +
                    std::to_string(digits_after_point));
    const Integer tens = power(Integer(10), static_cast<std::uint64_t>(digits_after_point));
    return place_point(round_quotient(value.numerator() * tens, value.denominator()),
                       digits_after_point);
}

std::optional<std::string> exact_decimal(const Rational& value) {
    // A denominator 2^a 5^b needs max(a, b) digits.
    Integer rest = value.denominator();
    const auto twos = fmpz_val2(flint(rest));
    Integer odd;
    fmpz_tdiv_q_2exp(flint(odd), flint(rest), twos);
    const auto fives = odd == 1 ? 0 : fmpz_remove(flint(rest), flint(odd), flint(Integer(5)));
    if (odd != 1 && rest != 1) return std::nullopt;
    const auto digits = std::max<std::uint64_t>(twos, static_cast<std::uint64_t>(fives));
    if (digits > most_digits) return std::nullopt;
    return decimal(value, static_cast<int>(digits));
}

std::size_t hash_value(const Rational& value) {
    return hash_value(value.numerator()) * 31 + hash_value(value.denominator());
}

}  // namespace algae
