#pragma once
// exact: numbers without rounding, integers, rationals, cyclotomic numbers, polynomials and matrices, and enclosures.
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace algae {

/// An integer of any size, a value like `int`. Sums and products are Integers, not expressions that
/// refer to their operands, so `auto` is safe. Numbers below 2^62 in size (2^30 where addresses
/// have 32 bits) live in the object itself and cost what machine numbers cost; the others are FLINT's (`fmpz`), which uses GMP.
///
/// An operation whose result would need more than `largest_bit_length` bits throws `BoundReached`.
class Integer {
public:
    Integer() noexcept = default;

    /// Example: Integer(std::numeric_limits<std::uint64_t>::max()) + 1 == power(Integer(2), 64)
    template <std::integral T>
    Integer(T value) {
        static_assert(sizeof(T) <= sizeof(std::int64_t));
        if constexpr (sizeof(T) < sizeof(Word)) {
            word_ = static_cast<Word>(value);
        } else if constexpr (std::signed_integral<T>) {
            if (value >= -small_limit && value <= small_limit)
                word_ = static_cast<Word>(value);
            else
                set_large(static_cast<std::int64_t>(value));
        } else {
            if (value <= static_cast<std::make_unsigned_t<Word>>(small_limit))
                word_ = static_cast<Word>(value);
            else
                set_large(static_cast<std::uint64_t>(value));
        }
    }

    /// The number written in decimal, with an optional sign. Throws `Error` on anything else.
    ///
    /// Example: Integer("-12") == -12
    explicit Integer(std::string_view decimal);

    Integer(const Integer& other) : word_(other.word_) {
        if (!is_small()) copy_large();
    }
    Integer(Integer&& other) noexcept : word_(std::exchange(other.word_, 0)) {}
    Integer& operator=(const Integer& other) {
        if (is_small() && other.is_small())
            word_ = other.word_;
        else
            assign_large(other);
        return *this;
    }
    Integer& operator=(Integer&& other) noexcept {
        std::swap(word_, other.word_);
        return *this;
    }
    ~Integer() {
        if (!is_small()) clear_large();
    }
    friend void swap(Integer& left, Integer& right) noexcept { std::swap(left.word_, right.word_); }

    Integer& operator+=(const Integer& right) {
        if (!is_small() || !right.is_small() || !set_small(word_ + right.word_)) add_large(right);
        return *this;
    }
    Integer& operator-=(const Integer& right) {
        if (!is_small() || !right.is_small() || !set_small(word_ - right.word_))
            subtract_large(right);
        return *this;
    }
    Integer& operator*=(const Integer& right) {
        Word product = 0;
        if (!is_small() || !right.is_small() ||
            __builtin_mul_overflow(word_, right.word_, &product) || !set_small(product))
            multiply_large(right);
        return *this;
    }
    Integer& operator++() { return *this += 1; }
    Integer& operator--() { return *this -= 1; }

    friend Integer operator+(Integer left, const Integer& right) {
        return std::move(left += right);
    }
    friend Integer operator-(Integer left, const Integer& right) {
        return std::move(left -= right);
    }
    friend Integer operator*(Integer left, const Integer& right) {
        return std::move(left *= right);
    }
    friend Integer operator-(Integer value) {
        value.negate();
        return value;
    }
    /// Changes the sign in place.
    void negate() {
        if (is_small())
            word_ = -word_;
        else
            negate_large();
    }

    friend bool operator==(const Integer& left, const Integer& right) {
        return left.word_ == right.word_ ||
               (!left.is_small() && !right.is_small() && compare_large(left, right) == 0);
    }
    friend std::strong_ordering operator<=>(const Integer& left, const Integer& right) {
        if (left.is_small() && right.is_small()) return left.word_ <=> right.word_;
        return compare_large(left, right) <=> 0;
    }

    bool is_zero() const { return word_ == 0; }
    bool is_even() const;
    bool fits_int64() const;
    bool fits_uint64() const;
    /// Throws `Error` if the number does not fit.
    std::int64_t to_int64() const;
    /// Throws `Error` if the number is negative or does not fit.
    std::uint64_t to_uint64() const;
    /// The nearest double, ties to even; infinite beyond the doubles.
    double to_double() const { return is_small() ? static_cast<double>(word_) : large_to_double(); }

    /// No Integer has more bits than this: it would fill a GiB, or 128 MiB where addresses have 32 bits.
    static constexpr std::uint64_t largest_bit_length = std::uint64_t{1}
                                                        << (sizeof(void*) < 8 ? 30 : 33);

private:
    friend struct FlintHandle;  // exact/flint.hpp, for the .cpp files of this room

    /// FLINT's `slong`, as long as an address; which of the two types matters for pointers to it.
    using Word = std::conditional_t<sizeof(long) == sizeof(void*), long, long long>;
    static constexpr int small_bits = std::numeric_limits<Word>::digits - 1;  // 62 or 30
    static constexpr Word small_limit = (Word{1} << small_bits) - 1;

    /// FLINT marks a word that stands for a GMP number by its two highest bits, 01.
    bool is_small() const { return word_ >> small_bits != 1; }
    /// Takes the value if it is small; the old one must be small.
    bool set_small(Word value) {
        if (value < -small_limit || value > small_limit) return false;
        word_ = value;
        return true;
    }
    void set_large(std::int64_t value);
    void set_large(std::uint64_t value);
    void copy_large();
    void assign_large(const Integer& other);
    void clear_large() noexcept;
    void add_large(const Integer& right);
    void subtract_large(const Integer& right);
    void multiply_large(const Integer& right);
    void negate_large();
    double large_to_double() const;
    static int compare_large(const Integer& left, const Integer& right);

    Word word_ = 0;  // FLINT's fmpz
};

/// The quotient rounded towards minus infinity. Throws `Error` if `divisor` is 0.
///
/// Example: floor_divide(-7, 2) == -4
Integer floor_divide(const Integer& dividend, const Integer& divisor);

/// dividend - divisor * floor_divide(dividend, divisor): it has the sign of the divisor, so it is
/// not negative for a positive one. Throws `Error` if `divisor` is 0.
///
/// Example: remainder(Integer(-7), 3) == 2
Integer remainder(const Integer& dividend, const Integer& divisor);

/// The quotient of a division without remainder. Throws `Error` if there is one, or on 0.
///
/// Example: exact_divide(Integer(-12), 4) == -3
Integer exact_divide(const Integer& dividend, const Integer& divisor);

/// The greatest common divisor, never negative; gcd(0, 0) is 0.
///
/// Example: gcd(Integer(12), -18) == 6
Integer gcd(const Integer& left, const Integer& right);

/// The least common multiple, never negative.
///
/// Example: lcm(4, 6) == 12
Integer lcm(const Integer& left, const Integer& right);

/// Throws `BoundReached` if the result would be longer than `Integer::largest_bit_length`.
///
/// Example: power(Integer(10), 3) == 1000
Integer power(const Integer& base, std::uint64_t exponent);

/// Example: abs(Integer(-5)) == 5
Integer abs(Integer value);

/// -1, 0 or 1.
///
/// Example: sign(Integer(-5)) == -1
int sign(const Integer& value);

/// The number of binary digits of the absolute value.
///
/// Example: bit_length(Integer(8)) == 4
std::uint64_t bit_length(const Integer& value);

/// The decimal digits, after a minus sign if negative. Nearly linear time in the number of digits.
///
/// Example: to_string(power(Integer(2), 70)) == "1180591620717411303424"
std::string to_string(const Integer& value);

std::ostream& operator<<(std::ostream& out, const Integer& value);

std::size_t hash_value(const Integer& value);

}  // namespace algae

template <>
struct std::hash<algae::Integer> {
    std::size_t operator()(const algae::Integer& value) const { return hash_value(value); }
};
