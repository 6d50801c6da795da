#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "exact/exact.hpp"
#include "rewrite/detail/exact_numbers.hpp"
#include "rewrite/rewrite.hpp"

// Exact arithmetic of parameters.
//
// A number that a double holds is that double; others are kept in a list, rationals once, so that equal numbers have equal bits.
// Most operations of doubles are found to be exact by the error terms of Dekker (1971) and by fused multiplication, and need no
// rational. Square roots of rationals are exact too, as long as sums have one root. What is neither is an enclosure of 512 bits: each operation gives a new one, and two of them are known to be
// equal only where they are the same entry of the list.

namespace algae {

namespace {

using Operation = Program::Operation;
using Known = WordValues::Known;

constexpr long precision = 512;            // bits of an enclosure
constexpr std::uint64_t longest = 33'220;  // bits of 10,000 digits

std::uint64_t bits(const Rational& value) {
    return std::max(bit_length(value.numerator()), bit_length(value.denominator()));
}
std::uint64_t bits(const QuadraticNumber& value) {
    return std::max(bits(value.rational), bits(value.factor));
}

[[noreturn]] void too_long(const Expression& at) {
    const std::string place = at.place.line == 0 ? "" : to_string(at.place) + ": ";
    throw BoundReached(Bound::method,
                       place + "the value of '" + to_text(at) + "' has more than 10,000 digits");
}

Ball ball(const Known& value) {
    return value.exact ? enclosure(*value.exact, precision) : *value.within;
}

Known exact(QuadraticNumber value) { return {std::move(value), std::nullopt}; }
Known exact(Rational value) { return exact(QuadraticNumber{std::move(value), 0, 1}); }

/// The number, if it is rational.
const Rational* rational(const Known& value) {
    return value.exact && value.exact->is_rational() ? &value.exact->rational : nullptr;
}
Known within(Ball value) { return {std::nullopt, std::move(value)}; }
Known truth_value(bool value) { return exact(Rational(value ? 1 : 0)); }

/// Nothing where it is not known.
Order order(const Known& x, const Known& y) {
    if (x.exact && y.exact)
        if (const auto difference = combined(*x.exact, '-', *y.exact)) {
            const int is = sign(*difference);
            return is < 0 ? Order::less : is > 0 ? Order::greater : Order::equal;
        }
    return compare(ball(x), ball(y));
}

/// Square roots, and sines, cosines and tangents of 30, 45, 60 degrees and their like.
std::optional<QuadraticNumber> with_root(Operation operation, const Rational& x) {
    if (operation == Operation::sqrt) return sign(x) > 0 ? square_root(x) : std::nullopt;
    const auto known = [](Rational degrees, int turn,
                          std::initializer_list<std::pair<int, QuadraticNumber>> all)
        -> std::optional<QuadraticNumber> {
        degrees -= Rational(floor(degrees / turn)) * turn;
        for (const auto& [angle, value] : all)
            if (degrees == Rational(angle)) return value;
        return std::nullopt;
    };
    const Rational half(1, 2), third(1, 3);
    if (operation == Operation::tan)
        return known(
            x, 180,
            {{30, {0, third, 3}}, {60, {0, 1, 3}}, {120, {0, -1, 3}}, {150, {0, -third, 3}}});
    if (operation != Operation::sin && operation != Operation::cos) return std::nullopt;
    const QuadraticNumber two{0, half, 2}, three{0, half, 3}, minus_two{0, -half, 2},
        minus_three{0, -half, 3};
    return known(operation == Operation::sin ? x : x + 90, 360,
                 {{45, two},
                  {60, three},
                  {120, three},
                  {135, two},
                  {225, minus_two},
                  {240, minus_three},
                  {300, minus_three},
                  {315, minus_two}});
}

/// An operation on numbers that need not be doubles.
class Slow {
public:
    Slow(Operation operation, Known x, Known y, const Expression& at, bool is_same)
        : operation_(operation), x_(std::move(x)), y_(std::move(y)), at_(at), is_same_(is_same) {}

    Known value() const {
        using enum Program::Operation;
        switch (operation_) {
            case negate:
                return x_.exact ? exact(negative(*x_.exact)) : within(-*x_.within);
            case invert:
                return truth_value(sign_of(x_) == 0);
            case truth:
                return truth_value(sign_of(x_) != 0);
            case add:
            case subtract:
            case multiply:
            case divide:
                return arithmetic();
            case Program::Operation::power:
                return raised();
            case less:
                return truth_value(compared() == Order::less);
            case less_equal:
                return truth_value(compared() != Order::greater);
            case greater:
                return truth_value(compared() == Order::greater);
            case greater_equal:
                return truth_value(compared() != Order::less);
            case equal:
                return truth_value(compared() == Order::equal);
            case unequal:
                return truth_value(compared() != Order::equal);
            case both:
                return truth_value(sign_of(x_) != 0 && sign_of(y_) != 0);
            case either:
                return truth_value(sign_of(x_) != 0 || sign_of(y_) != 0);
            default:
                return function();
        }
    }

private:
    [[noreturn]] void no_value() const {
        throw Undefined{&at_, reason(operation_, near(x_), near(y_), at_)};
    }
    [[noreturn]] void unknown() const {
        throw Undefined{&at_,
                        "the enclosures of " + std::to_string(precision) +
                            " bits do not say which value '" + to_text(at_) + "' has",
                        true};
    }
    static double near(const Known& value) {
        return rational(value) ? rational(value)->to_double() : ball(value).midpoint();
    }
    static QuadraticNumber negative(const QuadraticNumber& value) {
        return {-value.rational, -value.factor, value.radicand};
    }

    int sign_of(const Known& value) const {
        if (value.exact) return sign(*value.exact);
        const auto found = sign(*value.within);
        if (!found) unknown();
        return *found;
    }
    Order compared() const {
        if (is_same_) return Order::equal;
        const Order found = order(x_, y_);
        if (found == Order::unknown) unknown();
        return found;
    }
    Known finite(Ball value) const {
        if (!value.is_finite()) unknown();
        return within(std::move(value));
    }

    Known arithmetic() const {
        using enum Program::Operation;
        if (operation_ == divide && sign_of(y_) == 0) no_value();
        const char sign = operation_ == add        ? '+'
                          : operation_ == subtract ? '-'
                          : operation_ == multiply ? '*'
                                                   : '/';
        if (x_.exact && y_.exact)
            if (auto made = combined(*x_.exact, sign, *y_.exact)) return exact(*std::move(made));
        if (operation_ == multiply)  // what is 0 makes 0
            for (const Known* factor : {&x_, &y_})
                if (rational(*factor) && rational(*factor)->is_zero()) return *factor;
        const Ball x = ball(x_), y = ball(y_);
        return finite(operation_ == add        ? x + y
                      : operation_ == subtract ? x - y
                      : operation_ == multiply ? x * y
                                               : x / y);
    }

    Known raised() const {
        const int of_base = sign_of(x_), of_exponent = sign_of(y_);
        if (of_base == 0 && of_exponent < 0) no_value();
        if (of_exponent == 0) return exact(Rational(1));
        if (of_base == 0) return exact(Rational(0));
        const Rational* const exponent = rational(y_);
        const bool is_whole = exponent && exponent->is_integer();
        if (of_base < 0 && !is_whole) no_value();
        if (is_whole && x_.exact) return whole_power(*x_.exact, exponent->numerator());
        if (exponent && exponent->denominator() == 2 && rational(x_))
            if (const auto root = square_root(*rational(x_)))
                return whole_power(*root, exponent->numerator());
        return finite(power(ball(x_), ball(y_)));
    }

    Known whole_power(const QuadraticNumber& base, const Integer& exponent) const {
        if (base.is_rational() && abs(base.rational) == 1)
            return exact(exponent.is_even() ? Rational(1) : base.rational);
        if (abs(exponent) * Integer(bits(base)) > Integer(2 * longest)) too_long(at_);
        if (base.is_rational()) return exact(power(base.rational, exponent.to_int64()));
        QuadraticNumber made{1, 0, 1}, factor = base;
        for (std::uint64_t left = abs(exponent).to_uint64(); left > 0; left /= 2) {
            if (left % 2 == 1) made = *combined(made, '*', factor);
            if (left > 1) factor = *combined(factor, '*', factor);
        }
        return exact(sign(exponent) > 0 ? made : *combined({1, 0, 1}, '/', made));
    }

    /// A function of one number.
    Known function() const {
        using enum Program::Operation;
        if (const Rational* const of = rational(x_)) {
            if (auto value = rational_value(at_.name, *of)) return exact(*std::move(value));
            if (auto value = with_root(operation_, *of)) return exact(*std::move(value));
        }
        if (operation_ == floor || operation_ == ceil) return rounded();
        const Ball x = ball(x_);
        if (operation_ == abs && x_.exact)
            return exact(sign_of(x_) < 0 ? negative(*x_.exact) : *x_.exact);
        if (operation_ == abs) return within(algae::abs(x));
        if (operation_ == sqrt && sign_of(x_) < 0) no_value();
        if (operation_ == log && sign_of(x_) <= 0) no_value();
        if (operation_ == asin || operation_ == acos)
            if (order(exact(Rational(1)), within(algae::abs(x))) == Order::less) no_value();
        const Rational* const angle = rational(x_);
        if (operation_ == tan && angle && rational_value("cos", *angle) == Rational(0)) no_value();
        const Ball half_turn = Ball(180, precision), circle = pi(precision);
        switch (operation_) {
            case sqrt:
                return finite(algae::sqrt(x));
            case exp:
                return finite(algae::exp(x));
            case log:
                return finite(algae::log(x));
            case asin:
                return finite(algae::asin(x) * half_turn / circle);
            case acos:
                return finite(algae::acos(x) * half_turn / circle);
            case atan:
                return finite(algae::atan(x) * half_turn / circle);
            default:
                break;
        }
        const Ball sine =
            angle ? sin_pi(*angle / 180, precision) : algae::sin(x * circle / half_turn);
        const Ball cosine =
            angle ? cos_pi(*angle / 180, precision) : algae::cos(x * circle / half_turn);
        return finite(operation_ == sin ? sine : operation_ == cos ? cosine : sine / cosine);
    }

    /// floor or ceil of an enclosure.
    Known rounded() const {
        const auto of = [&](const Rational& end) {
            return operation_ == Operation::floor ? algae::floor(end) : ceiling(end);
        };
        const Ball x = ball(x_);
        const Integer low = of(x.lower());
        if (low != of(x.upper())) unknown();
        return exact(low);
    }

    Operation operation_;
    Known x_, y_;
    const Expression& at_;
    bool is_same_;
};

/// The result of an operation on two doubles, where a double is just that and that is quickly seen.
std::optional<double> quickly(Operation operation, double x, double y) {
    using enum Program::Operation;
    constexpr double tiny = 1e-270, huge = 1e270;  // far from where error terms are lost
    const auto fits = [](double value) {
        return value == 0 || (std::abs(value) > tiny && std::abs(value) < huge);
    };
    const auto of = [](bool value) { return value ? 1.0 : 0.0; };
    if (!fits(x) || !fits(y)) return std::nullopt;
    switch (operation) {
        case negate:
            return -x;
        case invert:
            return of(x == 0);
        case truth:
            return of(x != 0);
        case abs:
            return std::abs(x);
        case floor:
            return std::floor(x);
        case ceil:
            return std::ceil(x);
        case add:
        case subtract: {
            if (operation == subtract) y = -y;
            const double sum = x + y, part = sum - x;
            if ((x - (sum - part)) + (y - part) == 0) return sum;
            return std::nullopt;
        }
        case multiply: {
            const double product = x * y;
            if (fits(product) && (product != 0 || x == 0 || y == 0) &&
                std::fma(x, y, -product) == 0)
                return product;
            return std::nullopt;
        }
        case divide: {
            const double quotient = y == 0 ? 0 : x / y;
            if (y != 0 && fits(quotient) && (quotient != 0 || x == 0) &&
                std::fma(quotient, y, -x) == 0)
                return quotient;
            return std::nullopt;
        }
        case minimum:
            return y < x ? y : x;
        case maximum:
            return x < y ? y : x;
        case less:
            return of(x < y);
        case less_equal:
            return of(x <= y);
        case greater:
            return of(x > y);
        case greater_equal:
            return of(x >= y);
        case equal:
            return of(x == y);
        case unequal:
            return of(x != y);
        case both:
            return of(x != 0 && y != 0);
        case either:
            return of(x != 0 || y != 0);
        default:
            return std::nullopt;
    }
}

/// The value of an operation, where doubles do not quickly give it.
double worked_out(Operation operation, double x, double y, WordValues& numbers,
                  const Expression& at);

}  // namespace

double apply_exactly(Program::Operation operation, double x, double y, WordValues& numbers,
                     const Expression& at) {
    const bool are_doubles = !WordValues::is_held(x) && !WordValues::is_held(y);
    if (are_doubles)
        if (const auto value = quickly(operation, x, y)) return *value;
    const auto kind = static_cast<unsigned>(operation);
    if (const auto value = numbers.remembered(kind, x, y)) return *value;
    const bool is_enclosed = numbers.is_enclosure(x) || numbers.is_enclosure(y);
    numbers.spend_work(is_enclosed ? 10 : 1);
    const double value = worked_out(operation, x, y, numbers, at);
    if (!numbers.is_enclosure(value))
        numbers.remember(kind, x, y, value);
    else if (!is_enclosed)
        numbers.spend_work(9);
    return value;
}

namespace {

double worked_out(Operation operation, double x, double y, WordValues& numbers,
                  const Expression& at) {
    // The arguments of min and max go through unchanged: an enclosure keeps its place.
    const bool is_same = same_value(x, y);
    const Known left = numbers.known(x), right = numbers.known(y);
    if (operation == Operation::minimum || operation == Operation::maximum) {
        const Operation test =
            operation == Operation::minimum ? Operation::less_equal : Operation::greater_equal;
        return rational(Slow(test, left, right, at, is_same).value())->is_zero() ? y : x;
    }
    const Known value = Slow(operation, left, right, at, is_same).value();
    if (!value.exact) return numbers.number(*value.within);
    if (bits(*value.exact) > longest) too_long(at);
    return numbers.number(*value.exact);
}

/// Not a number, with the place of a value in a list in its bits.
double held_at(std::size_t place, std::uint64_t mark) {
    const std::uint64_t with_mark = 0x7FF8'0000'0000'0000 | mark | (place + 1);
    double value;
    std::memcpy(&value, &with_mark, sizeof value);
    return value;
}

/// The digits that all numbers of an enclosure begin with, 16 at most: "1.414213562373095…".
std::string first_digits(const Ball& value) {
    const double near = value.midpoint();
    const double exponent = near == 0 ? -400 : std::floor(std::log10(std::abs(near)));
    if (exponent < -5 || exponent > 14) return number_text(near) + "…";
    const int places = 15 - static_cast<int>(exponent);
    const Rational scale = power(Rational(10), places);
    const auto digits = [&](const Rational& end) { return floor(abs(end) * scale); };
    const Integer first = digits(value.lower());
    if (first != digits(value.upper())) return number_text(near) + "…";
    return (near < 0 ? "-" : "") + decimal(Rational(first) / scale, places) + "…";
}

std::size_t place_of(double value) {
    return static_cast<std::size_t>(bits_of(value) & 0x0003'FFFF'FFFF'FFFF) - 1;
}

}  // namespace

void WordValues::spend(std::uint64_t bytes) {
    bytes_ += bytes;
    if (bytes_ > memory_)
        throw BoundReached(Bound::memory, "the exact numbers of parameters take more than " +
                                              std::to_string(memory_ >> 20) + " MiB");
}

std::size_t WordValues::slot(unsigned operation, double left, double right) {
    constexpr std::size_t slots = 1 << 12;
    std::uint64_t hash = bits_of(left) * 0x9E37'79B9'7F4A'7C15 + bits_of(right) + operation;
    hash *= 0xBF58'476D'1CE4'E5B9;
    return static_cast<std::size_t>(hash >> 40) % slots;
}

std::optional<double> WordValues::remembered(unsigned operation, double left, double right) const {
    if (done_.empty()) return std::nullopt;
    const Done& known = done_[slot(operation, left, right)];
    if (known.operation != operation || known.left != bits_of(left) ||
        known.right != bits_of(right))
        return std::nullopt;
    return known.value;
}

void WordValues::remember(unsigned operation, double left, double right, double value) {
    if (done_.empty()) done_.resize(1 << 12);
    done_[slot(operation, left, right)] = {bits_of(left), bits_of(right), value, operation};
}

void WordValues::spend_work(std::uint64_t amount) {
    work_ += amount;
    if (work_ > most_work_)
        throw BoundReached(Bound::method, "exact parameters take more than " +
                                              std::to_string(most_work_) + " operations");
}

double WordValues::number(const QuadraticNumber& value) {
    if (value.is_rational()) {
        const double near = value.rational.to_double();
        const bool fits = std::isfinite(near) && (near != 0 || value.rational.is_zero());
        if (fits && exactly(near) == value.rational) return near == 0 ? 0.0 : near;
    }
    const std::uint64_t hash = hash_value(value);
    const auto [first, last] = number_places_.equal_range(hash);
    for (auto known = first; known != last; ++known)
        if (numbers_[known->second].exact == value) return held_at(known->second, number_bit);
    spend(sizeof(Known) + bits(value) / 2 + 80);
    number_places_.emplace(hash, numbers_.size());
    numbers_.push_back(exact(value));
    return held_at(numbers_.size() - 1, number_bit);
}

double WordValues::number(const Ball& value) {
    spend(sizeof(Known) + precision / 2);
    numbers_.push_back(within(value));
    return held_at(numbers_.size() - 1, number_bit);
}

WordValues::Known WordValues::known(double value) const {
    return is_held(value) ? numbers_.at(place_of(value)) : exact(exactly(value));
}

bool WordValues::is_enclosure(double value) const {
    return is_held_number(value) && numbers_.at(place_of(value)).within;
}

std::string WordValues::text(double value) const {
    if (is_held(value)) {
        const Known& number = numbers_.at(place_of(value));
        return rational(number) ? shortest_text(*rational(number)) : first_digits(ball(number));
    }
    const bool is_whole = value == std::trunc(value) && std::abs(value) < 1e15;
    return is_exact() && !is_whole ? shortest_text(exactly(value)) : number_text(value);
}

std::optional<bool> WordValues::equal(double left, double right) const {
    if (same_value(left, right)) return true;
    if (is_word(left) && is_word(right)) {
        const ModuleString &one = word(left), &other = word(right);
        if (one.kinds != other.kinds) return false;
        std::optional<bool> all = true;
        for (std::size_t i = 0; i < one.values.size(); ++i) {
            const auto same = equal(one.values[i], other.values[i]);
            if (same == false) return false;
            if (!same) all.reset();
        }
        return all;
    }
    if (is_word(left) || is_word(right) || (!is_enclosure(left) && !is_enclosure(right)))
        return false;
    switch (order(known(left), known(right))) {
        case Order::equal:
            return true;
        case Order::unknown:
            return std::nullopt;
        default:
            return false;
    }
}

namespace {

/// The nearest double, not 0 for what is not; infinite where it is too large.
double rounded(const Known& value) {
    const double near = rational(value) ? rational(value)->to_double() : ball(value).midpoint();
    const bool is_zero = rational(value) && rational(value)->is_zero();
    if (near != 0 || is_zero) return near == 0 ? 0 : near;
    const double least = std::numeric_limits<double>::denorm_min();
    const int is = value.exact ? sign(*value.exact) : sign(*value.within).value_or(0);
    return is * least;
}

/// Rounds values of a list into another one; false where one is too large.
class Rounding {
public:
    Rounding(const WordValues& from, WordValues& to) : from_(from), to_(to) {}

    bool round(ModuleString& word) {
        for (double& value : word.values)
            if (WordValues::is_held(value)) {
                const auto made = rounded_value(value);
                if (!made) return false;
                value = *made;
            }
        return true;
    }

private:
    std::optional<double> rounded_value(double value) {
        if (!WordValues::is_word(value)) {
            const double made = rounded(from_.known(value));
            return std::isfinite(made) ? std::optional(made) : std::nullopt;
        }
        const auto known = words_.find(bits_of(value));
        if (known != words_.end()) return known->second;
        ModuleString word = from_.word(value);
        if (!round(word)) return std::nullopt;
        const double made = to_.value(std::move(word), Budget());
        words_.emplace(bits_of(value), made);
        return made;
    }

    const WordValues& from_;
    WordValues& to_;
    std::unordered_map<std::uint64_t, double> words_;
};

}  // namespace

bool round_numbers(ModuleKinds& kinds, ModuleString& word) {
    const std::shared_ptr<WordValues> from = kinds.held();
    if (!from || !from->is_exact()) return true;
    auto to = std::make_shared<WordValues>();
    ModuleString made = word;
    if (!Rounding(*from, *to).round(made)) return false;
    const bool has_words = std::any_of(made.values.begin(), made.values.end(), WordValues::is_word);
    kinds.hold(has_words ? std::move(to) : nullptr);
    word = std::move(made);
    return true;
}

}  // namespace algae
