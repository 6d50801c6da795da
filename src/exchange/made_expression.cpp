#include "exchange/made_expression.hpp"

#include <utility>

namespace algae {

Expression number_expression(const Rational& value) {
    Expression out;
    out.value = value;
    return out;
}

Expression made_expression(Expression::Kind kind, const std::string& name,
                           std::vector<Expression> operands) {
    Expression out;
    out.kind = kind;
    out.name = name;
    out.operands = std::move(operands);
    return out;
}

}  // namespace algae
