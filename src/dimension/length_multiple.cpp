#include "dimension/length_multiple.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "dimension/constant_expression.hpp"

namespace algae {

namespace {

using Kind = Expression::Kind;

Expression number(const Rational& value) { return quantity(value).expression; }

const Quantity* constant(const std::string& name, const LSystem& system) {
    for (const auto& [known, value] : system.constants)
        if (known == name) return &value;
    return nullptr;
}

}  // namespace

LengthMultiple multiple_of(const Expression& expression, const ModuleValues& values,
                           const LSystem& system) {
    if (expression.kind == Kind::name) {
        if (values.length == expression.name) return {true, number(1)};
        const auto known = values.numbers.find(expression.name);
        if (known != values.numbers.end()) return {false, number(known->second)};
        if (const Quantity* named = constant(expression.name, system))
            return multiple_of(named->expression, {}, system);
        throw Error("'" + expression.name + "' is no number that rules keep count of");
    }
    std::vector<LengthMultiple> operands;
    for (const Expression& operand : expression.operands)
        operands.push_back(multiple_of(operand, values, system));
    Expression whole = expression;
    for (std::size_t k = 0; k < operands.size(); ++k) whole.operands[k] = operands[k].factor;
    const auto lengths =
        std::count_if(operands.begin(), operands.end(), [](const LengthMultiple& x) {
            return x.of_length && rational_value(x.factor) != Rational(0);
        });
    if (lengths == 0) return {false, shortened(std::move(whole))};
    const std::string& name = expression.name;
    const bool is_sum = expression.kind == Kind::binary && (name == "+" || name == "-");
    const bool is_multiple =
        (expression.kind == Kind::unary && name == "-") ||
        (expression.kind == Kind::binary && name == "*" && lengths == 1) ||
        (expression.kind == Kind::binary && name == "/" && lengths == 1 && operands[0].of_length) ||
        (is_sum && (lengths == 2 || rational_value(operands[0].factor) == Rational(0) ||
                    rational_value(operands[1].factor) == Rational(0)));
    if (!is_multiple)
        throw Error("the length '" + to_text(expression) +
                    "' is no multiple of that of the module it comes from");
    return {true, shortened(std::move(whole))};
}

Rational exact_number(const Expression& expression, const ModuleValues& values,
                      const LSystem& system) {
    const LengthMultiple found = multiple_of(expression, values, system);
    const auto value = found.of_length ? std::nullopt : rational_value(found.factor);
    if (!value)
        throw Error("'" + to_text(expression) +
                    "', which conditions or turns depend on, is no rational number");
    return *value;
}

}  // namespace algae
