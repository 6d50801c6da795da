#pragma once

#include <atomic>
#include <chrono>
#include <compare>
#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <initializer_list>
#include <iosfwd>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

// exact: what every other room stands on: numbers that are exact or enclosed, the two ways of ending without an answer (an
// error in the input, a stop), budgets and threads of long work, and the concepts of the algebra that analyses compute in.
//
// Outside libraries for numbers (GMP, FLINT, Arb) are behind this face only: no other room sees their types. Read in this
// order: errors and stops; budgets; pieces of sentences; monoids; integers, rationals, enclosures; matrices, polynomials,
// cyclotomic integers.

namespace algae {

/// A place in a text: lines and columns count from 1, columns in characters (not bytes).
/// Line 0 means the file as a whole.
struct Place {
    std::string file;
    std::size_t line = 0;
    std::size_t column = 0;

    bool operator==(const Place&) const = default;
    bool operator<(const Place& other) const {
        return std::tie(file, line, column) < std::tie(other.file, other.line, other.column);
    }
};

/// "koch.lsys:3:11", or "koch.lsys" where the whole file is meant.
///
/// Example: to_string(Place{"koch.lsys", 3, 11}) == "koch.lsys:3:11"
std::string to_string(const Place& place);

/// Bad input or bad usage. The message names the place, what was expected and what was found.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The work was stopped before its answer. This says nothing about the input, so it is no `Error`:
/// who catches errors to go on, or to judge what was given, never catches a stop by that.
class Stopped : public std::exception {
public:
    explicit Stopped(const std::string& message) : message_(message) {}
    const char* what() const noexcept override { return message_.what(); }

private:
    std::runtime_error message_;  // copies of it throw nothing, as copies of an exception must
};

/// Somebody asked the work to stop (Ctrl-C).
struct Interrupted : Stopped {
    Interrupted() : Stopped("interrupted") {}
};

/// What was used up. A budget gives `letters`, `memory` and `time`, and more of it takes the work
/// further; `nodes` are those of a picture that a caller allows. The other two no caller moves: `digits`
/// are those of the numbers that are worked with, and `method` is how far a method goes at all.
enum class Bound { letters, memory, time, nodes, digits, method };

/// Whether a larger budget takes the work further.
///
/// Example: is_of_budget(Bound::time) && !is_of_budget(Bound::method)
inline bool is_of_budget(Bound bound) {
    return bound == Bound::letters || bound == Bound::memory || bound == Bound::time;
}

/// A bound was reached before the answer. The message says which and what to use instead; `came`
/// says how far the work came, where that is known, and ends the message.
class BoundReached : public Stopped {
public:
    BoundReached(Bound bound, const std::string& message, const std::string& came = {})
        : Stopped(came.empty() ? message : message + "; undecided: " + came),
          bound_(bound),
          came_(came) {}
    Bound bound() const { return bound_; }
    const char* came() const { return came_.what(); }

private:
    Bound bound_;
    std::runtime_error came_;
};

/// One finding about a text: where, what, and the line it stands in.
struct Diagnostic {
    Place place;
    std::string message;
    std::string line;       // the line itself, shortened around the place if it is very long
    std::size_t caret = 0;  // 0-based column of the caret within `line`

    /// The finding as a compiler would print it, without a line break at the end:
    ///
    ///     koch.lsys:3:11: error: unmatched ']'
    ///       F -> F+F]--F+F
    ///               ^
    std::string text() const;
};

/// Everything that is wrong with one text, in order of place. Never empty.
class Diagnostics : public Error {
public:
    explicit Diagnostics(std::vector<Diagnostic> findings);
    const std::vector<Diagnostic>& findings() const { return findings_; }

private:
    std::vector<Diagnostic> findings_;
};

/// What those who set the bounds of a budget call them, as a command its options; for messages.
struct BoundNames {
    const char *letters, *memory, *time;
};

/// What a piece of work may use, and whether somebody wants it to stop. A budget is an argument,
/// never a global; long loops call `check` every few thousand steps.
class Budget {
public:
    static constexpr std::uint64_t default_letters = 1'000'000'000;
    static constexpr std::uint64_t default_memory = std::uint64_t{4} << 30;  // bytes

    std::uint64_t letters = default_letters;  // letters of a word that may be written out
    std::uint64_t memory = default_memory;    // bytes that tables and sets may take
    std::optional<std::chrono::steady_clock::time_point> deadline;
    const std::atomic<bool>* stop = nullptr;  // set by a signal handler
    /// Called by every `check`, by several threads at once; throws a `Stopped` to stop the work. For signals that
    /// another language keeps, and for tests that stop the work wherever it can be stopped.
    const std::function<void()>* at_check = nullptr;
    const BoundNames* names = nullptr;

    /// Throws `Interrupted` if the work was asked to stop, `BoundReached` past the deadline.
    void check() const;

    /// Throws `BoundReached` if `bytes` is more than `memory`, or more than a std::size_t holds; `what`
    /// names the table or set.
    void check_memory(std::uint64_t bytes, const char* what) const;

    /// " by NAME" where whoever set the bound calls it so, to follow "allowed" or "set" in a message; nothing
    /// where it has no name.
    std::string by(Bound bound) const;
};

/// How far some work has come, from 0 to 1. Called now and then; may do nothing.
class Progress {
public:
    virtual ~Progress() = default;
    virtual void report(double done) = 0;
};

/// What one thread does with the part of this number.
using PartWorker = std::function<void(std::size_t part)>;

/// Does the work for parts 0 up to count - 1, by as many threads (0: as many as the machine has) as
/// there are parts enough for, `least` for each; every thread gets a worker of its own. Of several errors the one of the
/// first part is thrown, so that it does not depend on the threads.
void each_part(std::size_t count, unsigned threads, const Budget& budget,
               const std::function<PartWorker()>& worker, std::size_t least = 16);

/// What is known of a statement. There is no conversion to bool: `undecided` is neither. A bound that is reached
/// gives `undecided`, never one of the others.
enum class Truth { proved, refuted, undecided };

/// "proved", "refuted" or "undecided".
///
/// Example: to_string(Truth::proved) == "proved"
std::string_view to_string(Truth truth);

/// The verdict on the opposite statement.
///
/// Example: opposite(Truth::proved) == Truth::refuted
Truth opposite(Truth truth);

// Pieces of sentences and messages.

/// The texts of these things one after the other, `between` between any two; `text` gives the text of one.
///
/// Example: joined(std::vector<int>{1, 2, 3}, "+", [](int n) { return std::to_string(n); }) == "1+2+3"
template <class Things, class Text = std::identity>
std::string joined(const Things& things, std::string_view between, Text text = {}) {
    std::string all;
    bool is_first = true;
    for (const auto& thing : things) {
        if (!is_first) all += between;
        is_first = false;
        all += std::invoke(text, thing);
    }
    return all;
}

/// The texts one after the other, `between` between any two.
///
/// Example: joined({"a", "b", "c"}, " ") == "a b c"
std::string joined(const std::vector<std::string>& texts, std::string_view between);

/// A list as a sentence has it: commas, and something else before the last text.
///
/// Example: listed({"a", "b", "c"}) + "; " + listed({"a", "b"}, " and ") == "a, b or c; a and b"
std::string listed(const std::vector<std::string>& texts, std::string_view before_last = " or ");

/// A number and what it counts.
///
/// Example: counted(1, "step") + ", " + counted(2, "step") == "1 step, 2 steps"
std::string counted(std::uint64_t count, std::string_view noun);

/// The name of a family or system behind "a" or "an", as it is spoken.
///
/// Example: with_article("0L") + ", " + with_article("E0L") == "a 0L, an E0L"
std::string with_article(const std::string& name);

/// The text, or where it is longer than so many bytes the whole characters that fit, and dots.
///
/// Example: beginning("abcdef", 4) == "abcd..."
std::string beginning(std::string_view text, std::size_t longest);

/// The text in quotation marks, cut after some forty bytes.
///
/// Example: quoted("x") == "'x'"
std::string quoted(std::string_view text);

/// The shortest decimal that is read back as the same number: "0.1", "1e-07".
///
/// Example: shortest_decimal(0.1) == "0.1"
std::string shortest_decimal(double value);

/// The decimal of at most so many significant digits, without zeros at its end (`%g` in C).
///
/// Example: rounded_decimal(2.0 / 3, 4) == "0.6667"
std::string rounded_decimal(double value, int significant_digits);

/// A monoid is a value: it may carry context (a modulus, an angle) that its elements do not.
/// `one` is the neutral element, `append` is left := left . right, associative.
/// tests/laws checks the laws for every model.
template <class M>
concept Monoid = std::copyable<M> && std::copyable<typename M::value_type> &&
    std::equality_comparable<typename M::value_type> &&
    requires(const M& m, typename M::value_type& left, const typename M::value_type& right) {
    { m.one() } -> std::same_as<typename M::value_type>;
    { m.append(left, right) } -> std::same_as<void>;
};

/// Bracketed words are free on letters, juxtaposition and the unary operation [ ]; a target that
/// gives brackets a meaning says what a branch is worth to the axis it grows on.
template <class M>
concept Branching = Monoid<M> && requires(const M& m, const typename M::value_type& twig) {
    { m.branch(twig) } -> std::same_as<typename M::value_type>;
};

/// A monoid with a commutative addition over which `append` distributes: what a letter with several
/// successors is folded into.
template <class S>
concept Semiring = Monoid<S> &&
    requires(const S& s, typename S::value_type& left, const typename S::value_type& right) {
    { s.zero() } -> std::same_as<typename S::value_type>;
    { s.add(left, right) } -> std::same_as<void>;
};

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
    friend struct FlintHandle;  // in detail/flint.hpp, for the .cpp files of this room

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

/// The number that a double is. Throws Error if it is infinite or none.
///
/// Example: exactly(0.75) == Rational(3, 4)
Rational exactly(double value);

/// rational + factor * sqrt(radicand), the radicand a squarefree integer other than 0 and 1, or
/// negative: then the number is complex. Of a rational number the radicand is 1.
struct QuadraticNumber {
    Rational rational;
    Rational factor;
    Integer radicand = 1;

    bool is_rational() const { return factor.is_zero(); }
    /// The same with the other sign before the root.
    QuadraticNumber conjugate() const { return {rational, -factor, radicand}; }
    bool operator==(const QuadraticNumber&) const = default;
    friend std::size_t hash_value(const QuadraticNumber& value);
};

/// The sum, difference, product or quotient, by `operation` + - * or /; nothing where both are roots of different numbers, or
/// the divisor is 0.
///
/// Example: combined({0, 1, 2}, '*', {0, 3, 2}) == QuadraticNumber{6, 0, 1}
std::optional<QuadraticNumber> combined(const QuadraticNumber& left, char operation,
                                        const QuadraticNumber& right);

/// -1, 0 or 1, of a real number.
///
/// Example: sign(QuadraticNumber{-3, 2, 2}) == -1
int sign(const QuadraticNumber& value);

/// The square root of a number above 0; nothing where its square part is not quickly found: numerator times denominator
/// has more than 12 digits and is no square.
///
/// Example: square_root(Rational(9, 2)) == QuadraticNumber{0, Rational(3, 2), 2}
std::optional<QuadraticNumber> square_root(const Rational& value);

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
    friend struct BallHandle;  // in detail/flint.hpp, for the .cpp files of this room
    struct Enclosure;

    std::unique_ptr<Enclosure> enclosure_;
    long bits_;
};

/// An enclosure of a real number.
Ball enclosure(const QuadraticNumber& value, long bits);

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
/// Of angles in radians.
Ball sin(const Ball& value);
Ball cos(const Ball& value);
/// In radians; everything where the number may be below -1 or above 1.
Ball asin(const Ball& value);
Ball acos(const Ball& value);
Ball atan(const Ball& value);
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

/// A matrix of integers, a value.
class IntegerMatrix {
public:
    IntegerMatrix() = default;
    /// The zero matrix.
    IntegerMatrix(std::size_t rows, std::size_t columns);
    /// Throws `Error` if the rows differ in length.
    ///
    /// Example: IntegerMatrix({{1, 1}, {1, 0}})(0, 1) == 1
    IntegerMatrix(std::initializer_list<std::initializer_list<Integer>> rows);
    explicit IntegerMatrix(const std::vector<std::vector<Integer>>& rows);

    static IntegerMatrix identity(std::size_t size);

    std::size_t rows() const { return rows_; }
    std::size_t columns() const { return columns_; }
    bool is_square() const { return rows_ == columns_; }
    bool is_zero() const;

    /// The entry in a row and a column, both counted from 0. Not checked.
    Integer& operator()(std::size_t row, std::size_t column) {
        return entries_[row * columns_ + column];
    }
    const Integer& operator()(std::size_t row, std::size_t column) const {
        return entries_[row * columns_ + column];
    }

    /// All three throw `Error` if the sizes do not fit.
    IntegerMatrix& operator+=(const IntegerMatrix& right);
    IntegerMatrix& operator-=(const IntegerMatrix& right);
    friend IntegerMatrix operator*(const IntegerMatrix& left, const IntegerMatrix& right);
    friend IntegerMatrix operator+(IntegerMatrix left, const IntegerMatrix& right) {
        return std::move(left += right);
    }
    friend IntegerMatrix operator-(IntegerMatrix left, const IntegerMatrix& right) {
        return std::move(left -= right);
    }
    friend bool operator==(const IntegerMatrix&, const IntegerMatrix&) = default;

private:
    friend struct FlintHandle;

    std::size_t rows_ = 0;
    std::size_t columns_ = 0;
    std::vector<Integer> entries_;  // row after row
};

/// The matrix times a column vector. Throws `Error` if the sizes do not fit.
///
/// Example: IntegerMatrix({{1, 1}, {1, 0}}) * std::vector<Integer>{3, 2} == std::vector<Integer>{5, 3}
std::vector<Integer> operator*(const IntegerMatrix& matrix, const std::vector<Integer>& vector);

/// A row vector times the matrix. Throws `Error` if the sizes do not fit.
std::vector<Integer> operator*(const std::vector<Integer>& vector, const IntegerMatrix& matrix);

/// The sum of the products of entries. Throws `Error` if the lengths differ.
Integer dot(const std::vector<Integer>& left, const std::vector<Integer>& right);

/// Example: transpose(IntegerMatrix({{1, 2}})) == IntegerMatrix({{1}, {2}})
IntegerMatrix transpose(const IntegerMatrix& matrix);

/// In log2(exponent) squarings. Throws `Error` if the matrix is not square or the exponent is
/// negative, `BoundReached` as soon as an entry is longer than `largest_bits` bits.
///
/// Example: power(IntegerMatrix({{1, 1}, {1, 0}}), 10)(0, 1) == 55
IntegerMatrix power(const IntegerMatrix& matrix, const Integer& exponent,
                    std::uint64_t largest_bits = std::uint64_t{1} << 30);

/// Throws `Error` if the matrix is not square.
Integer determinant(const IntegerMatrix& matrix);

/// The dimension of the space that the rows span over the rationals.
std::size_t rank(const IntegerMatrix& matrix);

/// The inverse of a square matrix over the rationals: `numerator` over `denominator`, the latter
/// positive, in lowest terms. Nothing where there is none. Throws `Error` if the matrix is not square.
struct RationalInverse {
    IntegerMatrix numerator;
    Integer denominator = 1;
};
///
/// Example: inverse(IntegerMatrix({{2, 0}, {0, 2}}))->denominator == 2
std::optional<RationalInverse> inverse(const IntegerMatrix& matrix);

/// A basis of the lattice that the rows span, in Hermite's normal form: as many rows as the rank,
/// pivots positive, entries above a pivot smaller than it and not negative (Cohen 1993, 2.4.2).
///
/// Example: lattice_basis(IntegerMatrix({{2, 4}, {3, 6}})) == IntegerMatrix({{1, 2}})
IntegerMatrix lattice_basis(const IntegerMatrix& rows);

/// A unimodular matrix that makes a basis (the rows, independent) one of short vectors: the product
/// of it and the rows is reduced in the sense of Lenstra, Lenstra and Lovasz (1982).
///
/// Example: reducing_matrix(IntegerMatrix({{1, 0}, {5, 1}})) * IntegerMatrix({{1, 0}, {5, 1}}) == IntegerMatrix({{1, 0}, {0, 1}})
IntegerMatrix reducing_matrix(const IntegerMatrix& rows);

/// "[1 1]\n[1 0]", for messages and tests.
std::string to_string(const IntegerMatrix& matrix);
std::ostream& operator<<(std::ostream& out, const IntegerMatrix& matrix);

/// A polynomial in one variable with integer coefficients.
class Polynomial {
public:
    Polynomial() = default;
    Polynomial(const Integer& constant);
    template <std::integral T>
    Polynomial(T constant) : Polynomial(Integer(constant)) {}
    /// Coefficients from the constant one upwards; zeros at the end are dropped.
    ///
    /// Example: to_string(Polynomial({-1, -1, 1})) == "x^2 - x - 1"
    explicit Polynomial(std::vector<Integer> coefficients);
    explicit Polynomial(std::initializer_list<Integer> coefficients)
        : Polynomial(std::vector<Integer>(coefficients)) {}
    /// coefficient * x^exponent.
    static Polynomial monomial(const Integer& coefficient, std::size_t exponent);

    /// -1 for the zero polynomial.
    long degree() const { return static_cast<long>(coefficients_.size()) - 1; }
    bool is_zero() const { return coefficients_.empty(); }
    /// 0 beyond the degree.
    Integer coefficient(std::size_t exponent) const {
        return exponent < coefficients_.size() ? coefficients_[exponent] : Integer();
    }
    const std::vector<Integer>& coefficients() const { return coefficients_; }
    /// 0 for the zero polynomial.
    Integer leading_coefficient() const {
        return coefficients_.empty() ? Integer() : coefficients_.back();
    }

    Polynomial& operator+=(const Polynomial& right);
    Polynomial& operator-=(const Polynomial& right);
    Polynomial& operator*=(const Polynomial& right);
    friend Polynomial operator+(Polynomial left, const Polynomial& right) {
        return std::move(left += right);
    }
    friend Polynomial operator-(Polynomial left, const Polynomial& right) {
        return std::move(left -= right);
    }
    friend Polynomial operator*(Polynomial left, const Polynomial& right) {
        return std::move(left *= right);
    }
    friend Polynomial operator-(Polynomial value);
    friend bool operator==(const Polynomial&, const Polynomial&) = default;

    Integer operator()(const Integer& x) const;
    Rational operator()(const Rational& x) const;
    Ball operator()(const Ball& x) const;

    /// Throws `BoundReached` if the result would be too long.
    friend Polynomial power(const Polynomial& base, std::uint64_t exponent);
    /// The greatest common divisor over the integers, leading coefficient not negative.
    ///
    /// Example: gcd(Polynomial({-1, 0, 1}), Polynomial({1, 2, 1})) == Polynomial({1, 1})
    friend Polynomial gcd(const Polynomial& left, const Polynomial& right);
    /// dividend / divisor if it is a polynomial with integer coefficients. Throws `Error` on 0.
    friend std::optional<Polynomial> exact_divide(const Polynomial& dividend,
                                                  const Polynomial& divisor);
    /// The remainder modulo a polynomial whose leading coefficient is 1 or -1; otherwise throws `Error`.
    friend Polynomial remainder(const Polynomial& dividend, const Polynomial& divisor);

private:
    friend struct FlintHandle;
    void drop_leading_zeros();

    std::vector<Integer> coefficients_;  // the last one is not 0
};

Polynomial derivative(const Polynomial& value);
/// The coefficients in the opposite order: x^degree p(1/x).
Polynomial reversed(const Polynomial& value);
/// The greatest common divisor of the coefficients, not negative.
Integer content(const Polynomial& value);
/// The polynomial over its content, leading coefficient positive; 0 for 0.
Polynomial primitive_part(const Polynomial& value);
/// Whether no factor of positive degree occurs twice.
bool is_squarefree(const Polynomial& value);

/// unit_and_content times the product of the factors, each irreducible over the rationals, primitive,
/// with a positive leading coefficient; in order of degree, then of coefficients from the top.
struct Factorisation {
    struct Power {
        Polynomial factor;
        unsigned exponent;
        bool operator==(const Power&) const = default;
    };
    Integer content;
    std::vector<Power> powers;
};

/// Throws `Error` on the zero polynomial. Van Hoeij's algorithm (FLINT).
///
/// Example: factorise(Polynomial({-2, 0, 2})).powers.size() == 2
Factorisation factorise(const Polynomial& value);

/// The minimal polynomial of exp(2 pi i / order). Throws `Error` unless 1 <= order <= 1,000,000.
///
/// Example: cyclotomic_polynomial(6) == Polynomial({1, -1, 1})
Polynomial cyclotomic_polynomial(long order);
/// The order of the roots of unity whose minimal polynomial this is, or nothing.
std::optional<unsigned long> cyclotomic_order(const Polynomial& value);

/// A root of a polynomial: enclosures of its real and imaginary part, and how often it occurs.
struct Root {
    Ball real;
    Ball imaginary;
    unsigned multiplicity;
    bool is_real;  // proved; then `imaginary` is exactly 0
};

/// All complex roots, isolated from each other, each enclosed to at least `bits` bits. Throws
/// `Error` on the zero polynomial.
std::vector<Root> roots(const Polynomial& value, long bits);

/// det(x - matrix). Throws `Error` if the matrix is not square.
///
/// Example: characteristic_polynomial(IntegerMatrix({{1, 1}, {1, 0}})) == Polynomial({-1, -1, 1})
Polynomial characteristic_polynomial(const IntegerMatrix& matrix);
/// The monic polynomial of least degree that the matrix is a root of. Throws `Error` if the matrix
/// is not square.
Polynomial minimal_polynomial(const IntegerMatrix& matrix);

/// "x^2 - x - 1".
std::string to_string(const Polynomial& value, const std::string& variable = "x");
std::ostream& operator<<(std::ostream& out, const Polynomial& value);

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

/// The natural numbers (or all integers) under addition. `bracket_pair` is what a pair of brackets
/// adds: 2 where brackets count as letters, 0 where only what stands between them counts.
struct Sums {
    using value_type = Integer;
    Integer bracket_pair = 2;

    Integer one() const { return 0; }
    void append(Integer& left, const Integer& right) const { left += right; }
    Integer branch(const Integer& twig) const { return twig + bracket_pair; }
};

/// Vectors of integers under addition: Parikh vectors.
struct Vectors {
    using value_type = std::vector<Integer>;
    std::size_t dimension = 0;

    value_type one() const { return value_type(dimension); }
    void append(value_type& left, const value_type& right) const {
        for (std::size_t i = 0; i < dimension; ++i) left[i] += right[i];
    }
};

/// How deep a word goes into brackets: `depth` at its end relative to its start, `lowest` the least
/// depth of any prefix. A word is balanced when both are 0.
struct BracketBalance {
    struct value_type {
        Integer depth = 0;
        Integer lowest = 0;
        bool operator==(const value_type&) const = default;
    };
    value_type one() const { return {}; }
    void append(value_type& left, const value_type& right) const {
        const Integer reached = left.depth + right.lowest;
        if (reached < left.lowest) left.lowest = reached;
        left.depth += right.depth;
    }
};

}  // namespace algae

template <>
struct std::hash<algae::Integer> {
    std::size_t operator()(const algae::Integer& value) const { return hash_value(value); }
};

template <>
struct std::hash<algae::Rational> {
    std::size_t operator()(const algae::Rational& value) const { return hash_value(value); }
};

template <>
struct std::hash<algae::CyclotomicInteger> {
    std::size_t operator()(const algae::CyclotomicInteger& value) const {
        return hash_value(value);
    }
};
