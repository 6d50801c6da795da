#pragma once

#include <optional>

#include "exact/ball.hpp"
#include "system/expression.hpp"

namespace algae {

/// An expression without names, with every operation on rational numbers done whose result is
/// rational: `0.3*0.7` becomes 0.21, `0.21^0.5` stays. A factor 1 is left out.
///
/// Throws `Diagnostics` where a part has no value.
Expression shortened(Expression expression);

/// The product of two expressions without names, shortened.
Expression times(const Expression& left, const Expression& right);

/// The rational number that a shortened expression is, if it is one.
std::optional<Rational> rational_value(const Expression& expression);

/// An enclosure of the value of an expression without names: of + - * / ^, sqrt, exp, log, abs and
/// of sines, cosines and tangents of rational numbers of degrees, beside all that is rational.
///
/// Throws Error for other functions of irrational numbers.
Ball enclosure(const Expression& constant, long bits);

}  // namespace algae
