#pragma once

#include <functional>
#include <string>

#include "exchange/scanner.hpp"
#include "system/expression.hpp"

namespace algae {

/// Reads a number as NetLogo writes it: `-8`, `1 / sqrt 2`, `(- 3) * 2e-1`, with blanks around
/// operators; `^` groups to the left there. Throws `Diagnostics` where there is no number or it has no
/// value. Brackets nest at most 100 deep, and there are at most 100 operators.
Quantity read_netlogo_number(Scanner& scanner);

/// The same written: expressions with what NetLogo knows, all else by its value.
///
/// Example: netlogo_number(evaluate(parsed("1/sqrt(2)"), {})) == "1 / sqrt 2"
std::string netlogo_number(const Quantity& number);

/// The number of the opposite sign.
///
/// Example: negated(quantity(45)) == quantity(-45)
Quantity negated(const Quantity& number);

/// 90 minus the number of degrees: a heading counted clockwise from the north for one
/// counter-clockwise from +x, and the other way round.
///
/// Example: turned_compass(quantity(25)) == quantity(65)
Quantity turned_compass(const Quantity& degrees);

}  // namespace algae
