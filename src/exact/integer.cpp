#include "exact/exact.hpp"

#include <cmath>
#include <cstdlib>
#include <ostream>

#include "exact/detail/flint.hpp"

namespace algae {

namespace {

constexpr int words_in_64_bits = 64 / FLINT_BITS;

/// 64 bits as FLINT's words, the lowest first.
struct Words {
    ulong value[words_in_64_bits]{};

    Words() = default;
    explicit Words(std::uint64_t whole) {
        for (int i = 0; i < words_in_64_bits; ++i)
            value[i] = static_cast<ulong>(whole >> (i * FLINT_BITS));
    }
    std::uint64_t whole() const {
        std::uint64_t result = 0;
        for (int i = 0; i < words_in_64_bits; ++i)
            result |= static_cast<std::uint64_t>(value[i]) << (i * FLINT_BITS);
        return result;
    }
};

[[noreturn]] void refuse_length(const char* what, double bits) {
    throw BoundReached(Bound::digits,
                       std::string("the ") + what + " would have about " +
                           std::to_string(static_cast<std::uint64_t>(bits / 1e6)) +
                           " million binary digits, more than the largest possible " +
                           std::to_string(Integer::largest_bit_length / 1000000) + " million");
}

void require_divisor(const Integer& divisor) {
    if (divisor.is_zero()) throw Error("expected a divisor other than 0, found 0");
}

/// The beginning of a text that may be long.
std::string shortened(std::string_view text) {
    return text.size() <= 60 ? std::string(text) : std::string(text.substr(0, 57)) + "...";
}

}  // namespace

Integer::Integer(std::string_view decimal) {
    std::string digits(
        decimal.substr(decimal.starts_with('+') || decimal.starts_with('-') ? 1 : 0));
    if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos)
        throw Error("expected an integer, found \"" + shortened(decimal) + "\"");
    fmpz_set_str(&word_, digits.c_str(), 10);
    if (decimal.starts_with('-')) negate();
}

void Integer::set_large(std::int64_t value) {
    const Words words(static_cast<std::uint64_t>(value));
    fmpz_set_signed_ui_array(&word_, words.value, words_in_64_bits);
}

void Integer::set_large(std::uint64_t value) {
    const Words words(value);
    fmpz_set_ui_array(&word_, words.value, words_in_64_bits);
}

void Integer::copy_large() {
    const Word other = word_;
    fmpz_init_set(&word_, &other);
}

void Integer::assign_large(const Integer& other) { fmpz_set(&word_, &other.word_); }
void Integer::clear_large() noexcept { fmpz_clear(&word_); }
void Integer::add_large(const Integer& right) { fmpz_add(&word_, &word_, &right.word_); }
void Integer::subtract_large(const Integer& right) { fmpz_sub(&word_, &word_, &right.word_); }
void Integer::negate_large() { fmpz_neg(&word_, &word_); }

void Integer::multiply_large(const Integer& right) {
    const std::uint64_t bits = std::uint64_t{fmpz_bits(&word_)} + fmpz_bits(&right.word_);
    if (bits > largest_bit_length) refuse_length("product", static_cast<double>(bits));
    fmpz_mul(&word_, &word_, &right.word_);
}

int Integer::compare_large(const Integer& left, const Integer& right) {
    return fmpz_cmp(&left.word_, &right.word_);
}

bool Integer::is_even() const { return fmpz_is_even(&word_) != 0; }

bool Integer::fits_int64() const {
    if (is_small()) return true;
    const auto bits = fmpz_bits(&word_);
    return bits < 64 || (bits == 64 && fmpz_sgn(&word_) < 0 && fmpz_val2(&word_) == 63);
}

bool Integer::fits_uint64() const { return fmpz_sgn(&word_) >= 0 && fmpz_bits(&word_) <= 64; }

std::int64_t Integer::to_int64() const {
    if (!fits_int64())
        throw Error("expected a number of at most 63 binary digits, found " +
                    (bit_length(*this) < 200 ? to_string(*this)
                                             : "one of " + std::to_string(bit_length(*this))));
    if (is_small()) return word_;
    Words words;
    fmpz_get_signed_ui_array(words.value, words_in_64_bits, &word_);
    return static_cast<std::int64_t>(words.whole());
}

std::uint64_t Integer::to_uint64() const {
    if (!fits_uint64())
        throw Error("expected a number from 0 of at most 64 binary digits, found " +
                    (bit_length(*this) < 200 ? to_string(*this)
                                             : "one of " + std::to_string(bit_length(*this))));
    if (is_small()) return static_cast<std::uint64_t>(word_);
    Words words;
    fmpz_get_ui_array(words.value, words_in_64_bits, &word_);
    return words.whole();
}

double Integer::large_to_double() const {
    const std::uint64_t bits = bit_length(*this);
    if (bits > 1024) return fmpz_sgn(&word_) < 0 ? -HUGE_VAL : HUGE_VAL;
    if (bits <= 64) {
        const auto size = static_cast<double>(abs(*this).to_uint64());
        return fmpz_sgn(&word_) < 0 ? -size : size;
    }
    // The 64 highest bits, the lowest of them set if anything below is: that rounds as the whole.
    const std::uint64_t shift = bits - 64;
    Integer top;
    fmpz_tdiv_q_2exp(&top.word_, &word_, static_cast<ulong>(shift));
    const bool inexact = fmpz_val2(&word_) < shift;
    const std::uint64_t size = abs(std::move(top)).to_uint64() | (inexact ? 1u : 0u);
    const double rounded = std::ldexp(static_cast<double>(size), static_cast<int>(shift));
    return fmpz_sgn(&word_) < 0 ? -rounded : rounded;
}

Integer floor_divide(const Integer& dividend, const Integer& divisor) {
    require_divisor(divisor);
    Integer quotient;
    fmpz_fdiv_q(flint(quotient), flint(dividend), flint(divisor));
    return quotient;
}

Integer remainder(const Integer& dividend, const Integer& divisor) {
    require_divisor(divisor);
    Integer rest;
    fmpz_fdiv_r(flint(rest), flint(dividend), flint(divisor));
    return rest;
}

Integer exact_divide(const Integer& dividend, const Integer& divisor) {
    require_divisor(divisor);
    Integer quotient;
    Integer rest;
    fmpz_tdiv_qr(flint(quotient), flint(rest), flint(dividend), flint(divisor));
    if (!rest.is_zero()) throw Error("expected a multiple of the divisor, found a remainder");
    return quotient;
}

Integer gcd(const Integer& left, const Integer& right) {
    Integer result;
    fmpz_gcd(flint(result), flint(left), flint(right));
    return result;
}

Integer lcm(const Integer& left, const Integer& right) {
    if (left.is_zero() || right.is_zero()) return 0;
    return abs(left) * exact_divide(abs(right), gcd(left, right));
}

Integer power(const Integer& base, std::uint64_t exponent) {
    const double least_bits =
        static_cast<double>(bit_length(base) - 1) * static_cast<double>(exponent);
    if (bit_length(base) > 1 && least_bits >= static_cast<double>(Integer::largest_bit_length))
        refuse_length("power", least_bits);
    // The powers of 0, 1 and -1 repeat after two, and all other exponents are small here.
    if (bit_length(base) <= 1 && exponent > 2) exponent = 2 - exponent % 2;
    Integer result;
    fmpz_pow_ui(flint(result), flint(base), static_cast<ulong>(exponent));
    return result;
}

Integer abs(Integer value) {
    if (sign(value) < 0) value.negate();
    return value;
}

int sign(const Integer& value) { return fmpz_sgn(flint(value)); }

std::uint64_t bit_length(const Integer& value) { return fmpz_bits(flint(value)); }

std::string to_string(const Integer& value) {
    std::string digits(fmpz_sizeinbase(flint(value), 10) + 2, '\0');
    fmpz_get_str(digits.data(), 10, flint(value));
    digits.resize(digits.find('\0'));
    return digits;
}

std::ostream& operator<<(std::ostream& out, const Integer& value) {
    return out << to_string(value);
}

std::size_t hash_value(const Integer& value) {
    const auto mix = [](std::uint64_t x) {  // the finaliser of splitmix64
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    };
    const fmpz word = *flint(value);
    if (!COEFF_IS_MPZ(word))
        return static_cast<std::size_t>(
            mix(static_cast<std::uint64_t>(word) + 0x9e3779b97f4a7c15u));
    const __mpz_struct* large = COEFF_TO_PTR(word);
    std::uint64_t hash = large->_mp_size < 0 ? 1 : 2;
    for (int i = 0; i < std::abs(large->_mp_size); ++i)
        hash = mix(hash + 0x9e3779b97f4a7c15u) ^ large->_mp_d[i];
    return static_cast<std::size_t>(mix(hash));
}

}  // namespace algae
