#pragma once

#include <string>
#include <vector>

#include "system/expression.hpp"

namespace algae {

/// Expressions as readers of other programs' files make them. Used within this room only.
Expression number_expression(const Rational& value);
Expression made_expression(Expression::Kind kind, const std::string& name,
                           std::vector<Expression> operands);

}  // namespace algae
