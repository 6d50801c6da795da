#include "dimension/constant_expression.hpp"

#include <utility>

#include "base/error.hpp"

namespace algae {

namespace {

bool is_number(const Expression& expression, const Rational& value) {
    return rational_value(expression) == value;
}

Ball power_of(const Expression& constant, const Ball& base, long bits) {
    const auto exponent = rational_value(constant.operands[1]);
    if (exponent && exponent->is_integer() && exponent->numerator().fits_int64()) {
        // Of negative numbers too, where logarithms do not exist.
        std::int64_t left = exponent->numerator().to_int64();
        const bool inverse = left < 0;
        if (inverse) left = -left;
        Ball result(1, bits), square = base;
        for (; left != 0; left >>= 1) {
            if (left & 1) result *= square;
            if (left > 1) square *= square;
        }
        return inverse ? Ball(1, bits) / result : result;
    }
    return power(base, enclosure(constant.operands[1], bits));
}

}  // namespace

std::optional<Rational> rational_value(const Expression& expression) {
    if (expression.kind == Expression::Kind::number) return expression.value;
    if (expression.kind == Expression::Kind::name || reads_words(expression)) return std::nullopt;
    return evaluate(expression, {}).exact;
}

Expression shortened(Expression expression) {
    using Kind = Expression::Kind;
    if (expression.kind == Kind::number) return expression;
    for (Expression& operand : expression.operands) operand = shortened(std::move(operand));
    if (const auto exact = rational_value(expression)) return quantity(*exact).expression;
    if (expression.kind != Kind::binary) return expression;
    const Expression &left = expression.operands[0], &right = expression.operands[1];
    if (expression.name == "*" && is_number(left, 1)) return right;
    if ((expression.name == "*" || expression.name == "/") && is_number(right, 1)) return left;
    return expression;
}

Expression times(const Expression& left, const Expression& right) {
    Expression found;
    found.kind = Expression::Kind::binary;
    found.name = "*";
    found.operands = {left, right};
    return shortened(std::move(found));
}

Ball enclosure(const Expression& constant, long bits) {
    if (const auto exact = rational_value(constant)) return Ball(*exact, bits);
    const auto operand = [&](std::size_t k) { return enclosure(constant.operands[k], bits); };
    const std::string& name = constant.name;
    if (constant.kind == Expression::Kind::unary && name == "-") return -operand(0);
    if (constant.kind == Expression::Kind::binary) {
        if (name == "+") return operand(0) + operand(1);
        if (name == "-") return operand(0) - operand(1);
        if (name == "*") return operand(0) * operand(1);
        if (name == "/") return operand(0) / operand(1);
        if (name == "^") return power_of(constant, operand(0), bits);
    }
    if (constant.kind == Expression::Kind::call) {
        if (name == "sqrt") return sqrt(operand(0));
        if (name == "exp") return exp(operand(0));
        if (name == "log") return log(operand(0));
        if (name == "abs") return abs(operand(0));
        const auto degrees = rational_value(constant.operands[0]);
        if (degrees && (name == "sin" || name == "cos" || name == "tan")) {
            const Rational part = *degrees / Rational(180);
            if (name == "sin") return sin_pi(part, bits);
            if (name == "cos") return cos_pi(part, bits);
            return sin_pi(part, bits) / cos_pi(part, bits);
        }
    }
    throw Error("no exact value of '" + to_text(constant) + "' is known");
}

}  // namespace algae
