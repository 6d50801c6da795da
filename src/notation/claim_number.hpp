#pragma once

#include "dimension/algebraic_integer.hpp"
#include "dimension/dimension_value.hpp"
#include "exact/polynomial.hpp"
#include "notation/claim_scanner.hpp"

namespace algae {

// Numbers in claims, as `algae dimension` prints them.

/// Reads `x^3 - x^2 - 2`, monic, of degree at most 100. Throws `SyntaxError`.
Polynomial parse_polynomial(ClaimScanner& scanner);

/// Reads `12`, `sqrt 10`, `10^(1/4)`, `(1+sqrt(5))/2`, `sqrt((3+sqrt(5))/2)`,
/// `the largest real root of x^3 - x^2 - 2` or `2.618, the square root of a root of x^2 - 3x + 1`: an
/// algebraic integer of at least 1. Throws `SyntaxError`.
AlgebraicInteger parse_algebraic(ClaimScanner& scanner);

/// Reads `log 4 / log 3`, a rational number, or several of them joined by `=` which have to be equal; a
/// decimal number behind a `=` is what comes before it, rounded. Throws `SyntaxError`.
DimensionValue parse_dimension_value(ClaimScanner& scanner);

}  // namespace algae
