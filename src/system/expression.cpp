#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "system/system.hpp"

// Expressions: their values, as exact as they can be, and their text.
//
// A value is a rational wherever the expression allows it, and a double beside it in any case. A chain of + - * / and integral powers
// keeps the rational; a function gives one only where it must be one (the sine of 30 degrees, the root of a square).
// Rationals of more than 100,000 bits are dropped and the double stays, so that no expression takes unbounded
// time. Errors carry the place of the part that has no value, because expressions are written by people in files.
// The text of an expression has as few brackets as reading it back allows: an operand is bracketed exactly where its
// operator binds less tightly than its surroundings.

namespace algae {

namespace {

/// A value on its way: exact as long as that is possible.
struct Value {
    std::optional<Rational> exact;
    double rounded = 0;
};

/// Values with more bits than this, numerator and denominator together, go on as doubles.
constexpr std::uint64_t longest_exact = 100'000;

std::uint64_t bits(const Rational& value) {
    return bit_length(value.numerator()) + bit_length(value.denominator());
}

/// Throws `Diagnostics` with this message at the place of an expression.
[[noreturn]] void fail(const Expression& at, std::string message) {
    throw Diagnostics({Diagnostic{at.place, std::move(message), {}, 0}});
}

/// The text of an expression, cut if it is long.
std::string shown(const Expression& expression) { return beginning(to_text(expression), 60); }

/// The value, if it is finite; otherwise fails at the expression.
Value finite(Value value, const Expression& at) {
    if (!std::isfinite(value.rounded)) fail(at, "the value of '" + shown(at) + "' is too large");
    return value;
}

Value exactly(const Rational& value, const Expression& at) {
    Value out{value, value.to_double()};
    if (bits(value) > longest_exact) out.exact.reset();
    return finite(std::move(out), at);
}

Value truth(bool value) { return {Rational(value ? 1 : 0), value ? 1.0 : 0.0}; }

bool is_zero(const Value& value) {
    return value.exact ? value.exact->is_zero() : value.rounded == 0;
}

/// -1, 0 or 1; exact if both are.
int compare(const Value& left, const Value& right) {
    if (left.exact && right.exact)
        return *left.exact < *right.exact ? -1 : *right.exact < *left.exact;
    return left.rounded < right.rounded ? -1 : left.rounded > right.rounded;
}

/// How tightly an operator binds; a number, a name or a call binds tightest.
enum Binding {
    loosest,
    disjunction,
    conjunction,
    relation,
    sum,
    product,
    prefix,
    raising,
    tightest
};

Binding binding(const Expression& expression) {
    switch (expression.kind) {
        case Expression::Kind::unary:
            return prefix;
        case Expression::Kind::binary:
            break;
        case Expression::Kind::number:
            if (sign(expression.value) < 0) return prefix;
            return exact_decimal(expression.value) ? tightest : product;
        default:
            return tightest;
    }
    const std::string& name = expression.name;
    if (name == "|") return disjunction;
    if (name == "&") return conjunction;
    if (name == "+" || name == "-") return sum;
    if (name == "*" || name == "/") return product;
    return name == "^" ? raising : relation;
}

void print(const Expression& expression, Binding least, std::string& out);

void print_binary(const Expression& expression, std::string& out) {
    const Binding own = binding(expression);
    const auto tighter = static_cast<Binding>(own + 1);
    // A relation does not chain, ^ groups to the right and takes a sign there, all others group left.
    const Binding left = own == raising || own == relation ? tighter : own;
    const Binding right = own == raising ? prefix : tighter;
    print(expression.operands.at(0), left, out);
    out += own <= relation ? ' ' + expression.name + ' ' : expression.name;
    print(expression.operands.at(1), right, out);
}

void print(const Expression& expression, Binding least, std::string& out) {
    const bool brackets = binding(expression) < least;
    if (brackets) out += '(';
    switch (expression.kind) {
        case Expression::Kind::number:
            out += shortest_text(expression.value);
            break;
        case Expression::Kind::name:
            out += expression.name;
            break;
        case Expression::Kind::word:
            out += '"' + expression.name + '"';
            break;
        case Expression::Kind::unary:
            out += expression.name;
            print(expression.operands.at(0), prefix, out);
            break;
        case Expression::Kind::binary:
            print_binary(expression, out);
            break;
        case Expression::Kind::call:
            out += expression.name + '(' + joined(expression.operands, ",", to_text) + ')';
            break;
    }
    if (brackets) out += ')';
}

Expression number(const Rational& value) {
    Expression out;
    out.value = value;
    return out;
}

Expression operation(Expression::Kind kind, std::string name, std::vector<Expression> operands) {
    Expression out;
    out.kind = kind;
    out.name = std::move(name);
    out.operands = std::move(operands);
    return out;
}

/// The expression that is read from the shortest text of a number.
Expression written(const Rational& value) {
    if (!exact_decimal(value))
        return operation(Expression::Kind::binary, "/",
                         {written(value.numerator()), number(value.denominator())});
    if (sign(value) < 0) return operation(Expression::Kind::unary, "-", {number(-value)});
    return number(value);
}

}  // namespace

std::string shortest_text(const Rational& value) {
    const auto decimal = exact_decimal(value);
    if (!decimal) return to_string(value);
    constexpr std::size_t readable = 21;  // shorter than this, an exponent only hinders
    if (decimal->size() <= readable) return *decimal;
    const std::string minus = decimal->front() == '-' ? "-" : "";
    std::string digits = decimal->substr(minus.size());
    long exponent = 0;
    if (const auto point = digits.find('.'); point != std::string::npos) {
        exponent = -static_cast<long>(digits.size() - point - 1);
        digits.erase(point, 1);
    }
    const auto first = digits.find_first_not_of('0');
    const auto last = digits.find_last_not_of('0');
    exponent += static_cast<long>(digits.size() - last - 1);
    std::string scientific =
        minus + digits.substr(first, last - first + 1) + 'e' + std::to_string(exponent);
    return scientific.size() < decimal->size() ? scientific : *decimal;
}

bool is_distance(const Expression& expression) {
    return expression.kind == Expression::Kind::call && expression.name == "distance";
}

bool reads_words(const Expression& expression) {
    if (expression.kind == Expression::Kind::word) return true;
    // What is called and is no function is a system.
    if (expression.kind == Expression::Kind::call &&
        (expression.name == "length" || !function_arity(expression.name)))
        return true;
    return std::any_of(expression.operands.begin(), expression.operands.end(), reads_words);
}

Quantity quantity(const Rational& value) { return {written(value), value, value.to_double()}; }

std::string to_text(const Expression& expression) {
    std::string out;
    print(expression, loosest, out);
    return out;
}

namespace {

/// The root of a square, by Newton's method from above; nothing of any other number.
std::optional<Integer> whole_root(const Integer& square) {
    if (square <= 1) return square;
    Integer root = power(Integer(2), (bit_length(square) + 1) / 2);
    while (true) {
        const Integer better = floor_divide(root + floor_divide(square, root), 2);
        if (better >= root) break;
        root = better;
    }
    if (root * root != square) return std::nullopt;
    return root;
}

std::optional<Rational> rational_root(const Rational& value) {
    if (sign(value) < 0) return std::nullopt;
    const auto numerator = whole_root(value.numerator());
    const auto denominator = numerator ? whole_root(value.denominator()) : std::nullopt;
    if (!denominator) return std::nullopt;
    return Rational(*numerator, *denominator);
}

/// The angle in degrees, from 0 up to a full turn.
Rational reduced(const Rational& degrees) { return degrees - Rational(floor(degrees / 360)) * 360; }
double reduced(double degrees) { return std::fmod(degrees, 360.0); }

/// Where it is rational (Niven): 0, 1/2 and 1, with signs.
std::optional<Rational> rational_sine(const Rational& degrees) {
    constexpr std::array<std::pair<int, int>, 8> halves{
        {{0, 0}, {30, 1}, {90, 2}, {150, 1}, {180, 0}, {210, -1}, {270, -2}, {330, -1}}};
    const Rational angle = reduced(degrees);
    for (const auto& [whole, half] : halves)
        if (angle == Rational(whole)) return Rational(half, 2);
    return std::nullopt;
}

std::optional<Rational> rational_tangent(const Rational& degrees) {
    const Rational angle = reduced(degrees);
    const Rational half = angle < 180 ? angle : angle - 180;
    if (half.is_zero()) return Rational(0);
    if (half == Rational(45)) return Rational(1);
    if (half == Rational(135)) return Rational(-1);
    return std::nullopt;
}

/// The angle in degrees of one of these numbers.
std::optional<Rational> rational_angle(const Rational& value,
                                       std::initializer_list<std::pair<Rational, Rational>> known) {
    for (const auto& [number, angle] : known)
        if (value == number) return angle;
    return std::nullopt;
}

std::optional<Rational> rational_arc_sine(const Rational& value) {
    const Rational half(1, 2);
    return rational_angle(value, {{0, 0}, {half, 30}, {1, 90}, {-half, -30}, {-1, -90}});
}

Value square_root(const Value& value, const Expression& at) {
    if (value.rounded < 0) fail(at, "the square root of a negative number in '" + shown(at) + "'");
    return {std::nullopt, std::sqrt(value.rounded)};
}

Value tangent(const Value& degrees, const Expression& at) {
    if (degrees.exact) {
        const Rational angle = reduced(*degrees.exact);
        if (angle == Rational(90) || angle == Rational(270))
            fail(at, "'" + shown(at) + "' has no value");
    }
    const double angle =
        degrees.exact ? reduced(*degrees.exact).to_double() : reduced(degrees.rounded);
    return finite({std::nullopt, std::tan(angle * std::numbers::pi / 180)}, at);
}

/// The value of a call with these arguments.
Value call(const Expression& at, const std::vector<Value>& values) {
    const std::string& name = at.name;
    const Value& first = values.at(0);
    if (name == "min" || name == "max") {
        const int wanted = name == "min" ? -1 : 1;
        Value best = first;
        for (const Value& value : values)
            if (compare(value, best) == wanted) best = value;
        return best;
    }
    if (first.exact)
        if (const auto value = rational_value(name, *first.exact)) return exactly(*value, at);
    const double angle = first.exact ? reduced(*first.exact).to_double() : reduced(first.rounded);
    if (name == "abs") return {std::nullopt, std::abs(first.rounded)};
    if (name == "floor") return {std::nullopt, std::floor(first.rounded)};
    if (name == "ceil") return {std::nullopt, std::ceil(first.rounded)};
    if (name == "sqrt") return square_root(first, at);
    if (name == "sin") return {std::nullopt, std::sin(angle * std::numbers::pi / 180)};
    if (name == "cos") return {std::nullopt, std::cos(angle * std::numbers::pi / 180)};
    if (name == "tan") return tangent(first, at);
    const double x = first.rounded;
    if (name == "exp") return finite({std::nullopt, std::exp(x)}, at);
    if (name == "atan") return {std::nullopt, std::atan(x) * 180 / std::numbers::pi};
    if (name == "log" && x <= 0)
        fail(at, "the logarithm of a number that is not positive in '" + shown(at) + "'");
    if (name == "log") return {std::nullopt, std::log(x)};
    if (std::abs(x) > 1) fail(at, "'" + shown(at) + "' needs a number from -1 to 1");
    return {std::nullopt, (name == "asin" ? std::asin(x) : std::acos(x)) * 180 / std::numbers::pi};
}

}  // namespace

std::optional<Rational> rational_value(std::string_view function, const Rational& value) {
    if (function == "abs") return abs(value);
    if (function == "floor") return floor(value);
    if (function == "ceil") return ceiling(value);
    if (function == "sqrt") return rational_root(value);
    if (function == "sin") return rational_sine(value);
    if (function == "cos") return rational_sine(value + 90);
    if (function == "tan") return rational_tangent(value);
    if (function == "asin") return rational_arc_sine(value);
    if (function == "acos") {
        const auto sine = rational_arc_sine(value);
        if (sine) return Rational(90) - *sine;
    }
    if (function == "atan") return rational_angle(value, {{0, 0}, {1, 45}, {-1, -45}});
    if (function == "exp" && value.is_zero()) return Rational(1);
    if (function == "log" && value == Rational(1)) return Rational(0);
    return std::nullopt;
}

const std::vector<std::string>& function_names() {
    static const std::vector<std::string> names{
        "abs",   "acos",   "asin", "atan", "ceil", "cos", "distance", "exp",
        "floor", "length", "log",  "max",  "min",  "sin", "sqrt",     "tan"};
    return names;
}

std::optional<Arity> function_arity(std::string_view name) {
    const auto& names = function_names();
    if (std::find(names.begin(), names.end(), name) == names.end()) return std::nullopt;
    const bool any = name == "min" || name == "max";
    return Arity{any || name == "distance" ? std::size_t{2} : std::size_t{1}, any};
}

namespace {

Value power(const Value& base, const Value& exponent, const Expression& at) {
    if (is_zero(base) && exponent.rounded < 0)
        fail(at, "a negative power of 0 in '" + shown(at) + "'");
    if (base.exact && exponent.exact && exponent.exact->is_integer()) {
        if (abs(*base.exact) == 1 || base.exact->is_zero()) {
            const bool even = exponent.exact->numerator().is_even();
            if (exponent.exact->is_zero()) return truth(true);
            return exactly(even ? abs(*base.exact) : *base.exact, at);
        }
        const Integer size = abs(exponent.exact->numerator()) * Integer(bits(*base.exact));
        if (size <= Integer(longest_exact))
            return exactly(power(*base.exact, exponent.exact->numerator().to_int64()), at);
    }
    const double rounded = std::pow(base.rounded, exponent.rounded);
    if (std::isnan(rounded))
        fail(at, "a power of a negative number that is not whole in '" + shown(at) + "'");
    return finite({std::nullopt, rounded}, at);
}

Value binary(const Expression& at, const Value& left, const Value& right) {
    const std::string& name = at.name;
    const auto arithmetic = [&](auto operation) {
        return left.exact && right.exact
                   ? exactly(operation(*left.exact, *right.exact), at)
                   : finite({std::nullopt, operation(left.rounded, right.rounded)}, at);
    };
    if (name == "|") return truth(!is_zero(left) || !is_zero(right));
    if (name == "&") return truth(!is_zero(left) && !is_zero(right));
    if (name == "=") return truth(compare(left, right) == 0);
    if (name == "!=") return truth(compare(left, right) != 0);
    if (name == "<") return truth(compare(left, right) < 0);
    if (name == "<=") return truth(compare(left, right) <= 0);
    if (name == ">") return truth(compare(left, right) > 0);
    if (name == ">=") return truth(compare(left, right) >= 0);
    if (name == "^") return power(left, right, at);
    if (name == "/" && is_zero(right)) fail(at.operands[1], "division by 0 in '" + shown(at) + "'");
    switch (name[0]) {
        case '+':
            return arithmetic(std::plus<>());
        case '-':
            return arithmetic(std::minus<>());
        case '*':
            return arithmetic(std::multiplies<>());
        default:
            return arithmetic(std::divides<>());
    }
}

Value value_of(const Expression& expression, const Names& names) {
    if (expression.kind == Expression::Kind::number)
        return finite({expression.value, expression.value.to_double()}, expression);
    if (expression.kind == Expression::Kind::name) {
        const Quantity* known = names ? names(expression.name) : nullptr;
        if (!known)
            fail(expression, "expected a number or a constant, found '" + expression.name + "'");
        return {known->exact, known->value};
    }
    if (is_distance(expression)) {
        const Quantity* known = names ? names(to_text(expression)) : nullptr;
        if (!known)
            fail(expression, "expected no distance but in the condition of a shape rule, found '" +
                                 shown(expression) + "'");
        return {known->exact, known->value};
    }
    if (reads_words(expression) &&
        (expression.kind == Expression::Kind::word || expression.kind == Expression::Kind::call))
        fail(expression, "expected a number, found " +
                             std::string(expression.name == "length" ? "" : "the word ") + "'" +
                             shown(expression) + "'");
    std::vector<Value> values;
    for (const Expression& operand : expression.operands)
        values.push_back(value_of(operand, names));
    if (expression.kind == Expression::Kind::call) return call(expression, values);
    if (expression.kind == Expression::Kind::binary)
        return binary(expression, values.at(0), values.at(1));
    if (expression.name == "!") return truth(is_zero(values.at(0)));
    if (values.at(0).exact) return exactly(-*values[0].exact, expression);
    return {std::nullopt, -values[0].rounded};
}

}  // namespace

Quantity evaluate(const Expression& expression, const Names& names) {
    Value value = value_of(expression, names);
    return {expression, std::move(value.exact), value.rounded};
}

}  // namespace algae
