#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "system/value.hpp"

namespace algae {

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

Value square_root(const Value& value, const Expression& at) {
    if (value.rounded < 0) fail(at, "the square root of a negative number in '" + shown(at) + "'");
    if (value.exact) {
        const auto numerator = whole_root(value.exact->numerator());
        const auto denominator = numerator ? whole_root(value.exact->denominator()) : std::nullopt;
        if (denominator) return exactly(Rational(*numerator, *denominator), at);
    }
    return {std::nullopt, std::sqrt(value.rounded)};
}

/// The angle in degrees, from 0 up to a full turn.
Value reduced(const Value& degrees) {
    if (!degrees.exact) return {std::nullopt, std::fmod(degrees.rounded, 360.0)};
    const Rational turned = *degrees.exact - Rational(floor(*degrees.exact / 360)) * 360;
    return {turned, turned.to_double()};
}

Value sine(const Value& degrees) {
    const Value angle = reduced(degrees);
    if (angle.exact) {
        constexpr std::array<std::pair<int, int>, 8> halves{
            // the angles whose sine is rational
            {{0, 0}, {30, 1}, {90, 2}, {150, 1}, {180, 0}, {210, -1}, {270, -2}, {330, -1}}};
        for (const auto& [whole, half] : halves)
            if (*angle.exact == Rational(whole)) return {Rational(half, 2), half / 2.0};
    }
    return {std::nullopt, std::sin(angle.rounded * std::numbers::pi / 180)};
}

Value cosine(const Value& degrees) {
    Value shifted{std::nullopt, degrees.rounded + 90};
    if (degrees.exact) shifted = {*degrees.exact + 90, 0};
    const Value out = sine(shifted);
    if (out.exact) return out;
    return {std::nullopt, std::cos(reduced(degrees).rounded * std::numbers::pi / 180)};
}

Value tangent(const Value& degrees, const Expression& at) {
    const Value angle = reduced(degrees);
    if (angle.exact) {
        const Rational half = *angle.exact < 180 ? *angle.exact : *angle.exact - 180;
        if (half == Rational(90)) fail(at, "'" + shown(at) + "' has no value");
        if (half.is_zero()) return truth(false);
        if (half == Rational(45)) return truth(true);
        if (half == Rational(135)) return {Rational(-1), -1};
    }
    return finite({std::nullopt, std::tan(angle.rounded * std::numbers::pi / 180)}, at);
}

}  // namespace

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
    if (name == "abs")
        return first.exact ? exactly(abs(*first.exact), at)
                           : Value{std::nullopt, std::abs(first.rounded)};
    if (name == "floor")
        return first.exact ? exactly(floor(*first.exact), at)
                           : Value{std::nullopt, std::floor(first.rounded)};
    if (name == "ceil")
        return first.exact ? exactly(ceiling(*first.exact), at)
                           : Value{std::nullopt, std::ceil(first.rounded)};
    if (name == "sqrt") return square_root(first, at);
    if (name == "sin") return sine(first);
    if (name == "cos") return cosine(first);
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

const std::vector<std::string>& function_names() {
    static const std::vector<std::string> names{"abs", "acos", "asin",  "atan", "ceil",
                                                "cos", "distance", "exp", "floor", "length", "log",
                                                "max", "min", "sin",  "sqrt", "tan"};
    return names;
}

std::optional<Arity> function_arity(std::string_view name) {
    const auto& names = function_names();
    if (std::find(names.begin(), names.end(), name) == names.end()) return std::nullopt;
    const bool any = name == "min" || name == "max";
    return Arity{any || name == "distance" ? std::size_t{2} : std::size_t{1}, any};
}

}  // namespace algae
