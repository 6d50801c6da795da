#include "exact/exact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>

#include "exact/detail/flint.hpp"

namespace algae {

namespace {

constexpr long most_bits = 1L << 30;
constexpr int moderate_exponent_bits = FLINT_BITS == 64 ? 32 : 30;
constexpr long first_bits = 64;

void require_bits(long bits) {
    if (bits < 2 || bits > most_bits)
        throw Error("expected a precision of 2 to 1073741824 bits, found " + std::to_string(bits));
}

/// Whether the numbers in the interval are below 2^exponent in size: what is far larger cannot be
/// written out as an Integer.
bool is_below(const arb_struct* value, long exponent) {
    return arf_cmpabs_2exp_si(arb_midref(value), exponent) < 0 &&
           mag_cmp_2exp_si(arb_radref(value), exponent) < 0;
}

/// Whether a number of this size can be written out: its exponent is moderate.
bool is_moderate(const arb_struct* value) {
    constexpr slong far = WORD(1) << moderate_exponent_bits;
    const bool midpoint =
        arf_is_zero(arb_midref(value)) || (arf_cmpabs_2exp_si(arb_midref(value), far) < 0 &&
                                           arf_cmpabs_2exp_si(arb_midref(value), -far) > 0);
    const bool radius =
        mag_is_zero(arb_radref(value)) || (mag_cmp_2exp_si(arb_radref(value), far) < 0 &&
                                           mag_cmp_2exp_si(arb_radref(value), -far) > 0);
    return midpoint && radius;
}

/// An exact end of an interval.
Rational exact_end(const Ball& ball, bool upper) {
    const arb_struct* value = arb(ball);
    if (!ball.is_finite()) throw Error("expected a finite interval, found " + to_string(ball));
    if (!is_moderate(value))
        throw BoundReached(Bound::digits, "the ends of an interval lie beyond 2^(2^" +
                                              std::to_string(moderate_exponent_bits) +
                                              ") or below 2^(-2^" +
                                              std::to_string(moderate_exponent_bits) + ")");
    arf_t low, high;
    arf_init(low);
    arf_init(high);
    arb_get_interval_arf(low, high, value, ARF_PREC_EXACT);
    fmpz_t mantissa, exponent;
    fmpz_init(mantissa);
    fmpz_init(exponent);
    arf_get_fmpz_2exp(mantissa, exponent, upper ? high : low);
    Integer top;
    Integer power_of_two;
    fmpz_swap(flint(top), mantissa);
    fmpz_swap(flint(power_of_two), exponent);
    fmpz_clear(mantissa);
    fmpz_clear(exponent);
    arf_clear(low);
    arf_clear(high);
    const Integer scale = power(Integer(2), abs(power_of_two).to_uint64());
    return sign(power_of_two) < 0 ? Rational(top, scale) : Rational(top * scale);
}

template <class Operation>
Ball applied(const Ball& value, Operation operation) {
    Ball result = ball(value.bits());
    operation(arb(result), arb(value), value.bits());
    return result;
}

/// round(10^digits * value) if all numbers in the interval agree on it.
std::optional<Integer> rounded(const Ball& value, int digits) {
    Ball scaled = value * Ball(power(Integer(10), static_cast<std::uint64_t>(std::max(digits, 0))),
                               value.bits());
    if (digits < 0)
        scaled /= Ball(power(Integer(10), static_cast<std::uint64_t>(-digits)), value.bits());
    scaled += Ball(Rational(1, 2), value.bits());
    // floor is exact only where the integer part fits in the precision.
    if (!scaled.is_finite() || !is_below(arb(scaled), value.bits())) return std::nullopt;
    Ball floored = ball(value.bits());
    arb_floor(arb(floored), arb(scaled), value.bits());
    return floored.unique_integer();
}

void require_digits(int digits, int least) {
    if (digits < least || digits > 10'000'000)
        throw Error("expected " + std::to_string(least) + " to 10000000 digits, found " +
                    std::to_string(digits));
}

[[noreturn]] void refuse_decimal(int digits, long largest_bits) {
    throw BoundReached(Bound::digits, "the number could not be rounded to " +
                                          std::to_string(digits) + " digits with " +
                                          std::to_string(largest_bits) +
                                          " bits: it lies on or very near the middle between two "
                                          "decimals; ask for its exact form "
                                          "or for another number of digits");
}

}  // namespace

arb_struct* BallHandle::of(Ball& value) { return value.enclosure_->value; }
const arb_struct* BallHandle::of(const Ball& value) { return value.enclosure_->value; }

Ball::Ball(const Rational& value, long bits) : Ball(Integer(), bits) {
    fmpq fraction{*flint(value.numerator()), *flint(value.denominator())};  // read where it lies
    arb_set_fmpq(enclosure_->value, &fraction, bits);
}

Ball::Ball(const Integer& value, long bits) : bits_(bits) {
    require_bits(bits);
    enclosure_ = std::make_unique<Enclosure>();
    if (!value.is_zero()) arb_set_round_fmpz(enclosure_->value, flint(value), bits);
}

Ball::Ball(const Ball& other)
    : enclosure_(std::make_unique<Enclosure>(*other.enclosure_)), bits_(other.bits_) {}
Ball::Ball(Ball&& other) noexcept = default;
Ball& Ball::operator=(Ball other) noexcept {
    enclosure_ = std::move(other.enclosure_);
    bits_ = other.bits_;
    return *this;
}
Ball::~Ball() = default;

bool Ball::is_finite() const { return arb_is_finite(enclosure_->value) != 0; }

bool Ball::contains(const Rational& value) const {
    const fmpq fraction{*flint(value.numerator()), *flint(value.denominator())};
    return arb_contains_fmpq(enclosure_->value, &fraction) != 0;
}

bool Ball::contains(const Ball& inner) const {
    return arb_contains(enclosure_->value, arb(inner)) != 0;
}
bool Ball::overlaps(const Ball& other) const {
    return arb_overlaps(enclosure_->value, arb(other)) != 0;
}

bool Ball::has_radius_below(long exponent) const {
    return mag_cmp_2exp_si(arb_radref(enclosure_->value), exponent) <= 0;
}

std::optional<Integer> Ball::unique_integer() const {
    if (!is_finite() ||
        !is_below(enclosure_->value, static_cast<long>(Integer::largest_bit_length)))
        return std::nullopt;
    Integer result;
    if (arb_get_unique_fmpz(flint(result), enclosure_->value) == 0) return std::nullopt;
    return result;
}

double Ball::midpoint() const { return arf_get_d(arb_midref(enclosure_->value), ARF_RND_NEAR); }

std::optional<double> Ball::unique_double() const {
    if (!is_finite()) return std::nullopt;
    arf_t bound;
    arf_init(bound);
    arb_get_lbound_arf(bound, enclosure_->value, bits_ + 64);
    const double low = arf_get_d(bound, ARF_RND_NEAR);
    arb_get_ubound_arf(bound, enclosure_->value, bits_ + 64);
    const double high = arf_get_d(bound, ARF_RND_NEAR);
    arf_clear(bound);
    if (low != high) return std::nullopt;
    return low == 0 ? 0 : low;  // no negative zero
}

Rational Ball::lower() const { return exact_end(*this, false); }
Rational Ball::upper() const { return exact_end(*this, true); }

Ball& Ball::operator+=(const Ball& right) {
    bits_ = std::max(bits_, right.bits_);
    arb_add(enclosure_->value, enclosure_->value, arb(right), bits_);
    return *this;
}

Ball& Ball::operator-=(const Ball& right) {
    bits_ = std::max(bits_, right.bits_);
    arb_sub(enclosure_->value, enclosure_->value, arb(right), bits_);
    return *this;
}

Ball& Ball::operator*=(const Ball& right) {
    bits_ = std::max(bits_, right.bits_);
    arb_mul(enclosure_->value, enclosure_->value, arb(right), bits_);
    return *this;
}

Ball& Ball::operator/=(const Ball& right) {
    bits_ = std::max(bits_, right.bits_);
    arb_div(enclosure_->value, enclosure_->value, arb(right), bits_);
    return *this;
}

Ball operator-(Ball value) {
    arb_neg(arb(value), arb(value));
    return value;
}

Order compare(const Ball& left, const Ball& right) {
    if (arb_lt(arb(left), arb(right))) return Order::less;
    if (arb_gt(arb(left), arb(right))) return Order::greater;
    if (arb_eq(arb(left), arb(right))) return Order::equal;
    return Order::unknown;
}

std::optional<int> sign(const Ball& value) {
    if (arb_is_positive(arb(value))) return 1;
    if (arb_is_negative(arb(value))) return -1;
    if (arb_is_zero(arb(value))) return 0;
    return std::nullopt;
}

Ball abs(const Ball& value) {
    return applied(value, [](auto* out, const auto* in, long) { arb_abs(out, in); });
}
Ball sqrt(const Ball& value) { return applied(value, arb_sqrt); }
Ball log(const Ball& value) { return applied(value, arb_log); }
Ball exp(const Ball& value) { return applied(value, arb_exp); }
Ball sin(const Ball& value) { return applied(value, arb_sin); }
Ball cos(const Ball& value) { return applied(value, arb_cos); }
Ball asin(const Ball& value) { return applied(value, arb_asin); }
Ball acos(const Ball& value) { return applied(value, arb_acos); }
Ball atan(const Ball& value) { return applied(value, arb_atan); }

Ball power(const Ball& base, const Ball& exponent) {
    Ball result = ball(std::max(base.bits(), exponent.bits()));
    arb_pow(arb(result), arb(base), arb(exponent), result.bits());
    return result;
}

Ball pi(long bits) {
    Ball result = ball(bits);
    arb_const_pi(arb(result), bits);
    return result;
}

Ball cos_pi(const Rational& value, long bits) {
    Ball result = ball(bits);
    const fmpq fraction{*flint(value.numerator()), *flint(value.denominator())};
    arb_cos_pi_fmpq(arb(result), &fraction, bits);
    return result;
}

Ball sin_pi(const Rational& value, long bits) {
    Ball result = ball(bits);
    const fmpq fraction{*flint(value.numerator()), *flint(value.denominator())};
    arb_sin_pi_fmpq(arb(result), &fraction, bits);
    return result;
}

Ball hull(const Ball& left, const Ball& right) {
    Ball result = ball(std::max(left.bits(), right.bits()));
    arb_union(arb(result), arb(left), arb(right), result.bits());
    return result;
}

std::string decimal(const std::function<Ball(long bits)>& enclose, int digits_after_point,
                    long largest_bits) {
    require_digits(digits_after_point, 0);
    largest_bits += 4L * digits_after_point;
    for (long bits = first_bits; bits <= largest_bits; bits *= 2)
        if (const auto scaled = rounded(enclose(bits), digits_after_point))
            return decimal(Rational(*scaled, power(Integer(10),
                                                   static_cast<std::uint64_t>(digits_after_point))),
                           digits_after_point);
    refuse_decimal(digits_after_point, largest_bits);
}

std::string significant_decimal(const std::function<Ball(long bits)>& enclose, int digits,
                                long largest_bits) {
    require_digits(digits, 1);
    largest_bits += 4L * digits;
    for (long bits = first_bits; bits <= largest_bits; bits *= 2) {
        const Ball value = enclose(bits);
        if (!value.is_finite() || arb_contains_zero(arb(value)) ||
            !is_below(arb(value), bits * 4) ||
            arf_cmpabs_2exp_si(arb_midref(arb(value)), -bits * 4) < 0)
            continue;
        // The place of the first digit: 10^(place-1) < |value|, at first because it is certainly too
        // low (the midpoint is at least 2^(two-1)), then because it was compared.
        fmpz_t exponent;
        fmpz_init(exponent);
        arf_abs_bound_lt_2exp_fmpz(exponent, arb_midref(arb(value)));
        const auto two = static_cast<double>(fmpz_get_si(exponent));
        fmpz_clear(exponent);
        long place = static_cast<long>(std::floor((two - 1) * 0.30102 - 1e-4 * std::abs(two)));
        const auto is_above = [&](long tens) {
            const Ball limit(power(Rational(10), tens), bits);
            return compare(abs(value), limit) == Order::greater;
        };
        while (is_above(place)) ++place;
        const long after_point = digits - place;
        if (after_point > 10'000'000 || after_point < -10'000'000)
            refuse_decimal(digits, largest_bits);
        const auto scaled = rounded(value, static_cast<int>(after_point));
        if (!scaled) continue;
        // 9.996 to three digits is 10.0: one digit less after the point.
        const auto order = abs(*scaled) <=> power(Integer(10), static_cast<std::uint64_t>(digits));
        if (order > 0) continue;
        const Integer tens = power(Integer(10), static_cast<std::uint64_t>(std::abs(after_point)));
        if (after_point <= 0) return to_string(*scaled * tens);
        const int shown = static_cast<int>(after_point) - (order == 0 ? 1 : 0);
        return decimal(Rational(*scaled, tens), shown);
    }
    refuse_decimal(digits, largest_bits);
}

std::string to_string(const Ball& value) {
    char* text = arb_get_str(arb(value), 30, 0);
    std::string result(text);
    flint_free(text);
    return result;
}

std::ostream& operator<<(std::ostream& out, const Ball& value) { return out << to_string(value); }

}  // namespace algae
