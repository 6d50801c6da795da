#include <cmath>
#include <utility>

#include "system/value.hpp"

namespace algae {

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
    const bool exact = left.exact && right.exact;
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
            if (exact) return exactly(*left.exact + *right.exact, at);
            return finite({std::nullopt, left.rounded + right.rounded}, at);
        case '-':
            if (exact) return exactly(*left.exact - *right.exact, at);
            return finite({std::nullopt, left.rounded - right.rounded}, at);
        case '*':
            if (exact) return exactly(*left.exact * *right.exact, at);
            return finite({std::nullopt, left.rounded * right.rounded}, at);
        default:
            if (exact) return exactly(*left.exact / *right.exact, at);
            return finite({std::nullopt, left.rounded / right.rounded}, at);
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
    if (reads_words(expression) && (expression.kind == Expression::Kind::word ||
                                    expression.kind == Expression::Kind::call))
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
