#pragma once

#include <vector>

#include "dimension/algebraic_integer.hpp"
#include "exact/polynomial.hpp"
#include "notation/claim_scanner.hpp"

namespace algae {

// Numbers in claims that are written with roots, and what these are read from.

/// Whether the next character that is no blank is a digit.
bool is_digit_next(ClaimScanner& scanner);

/// A natural number of at most 30 digits; messages call it `what`. Throws `SyntaxError`.
Integer parse_short(ClaimScanner& scanner, const char* what);

/// A number from 1 to `most`. Throws `SyntaxError`.
long parse_small(ClaimScanner& scanner, long most, const char* what);

/// The monic polynomial of the k-th roots of the roots.
Polynomial of_roots(const Polynomial& polynomial, long k);

/// The different irreducible factors.
std::vector<Polynomial> factors_of(const Polynomial& polynomial);

/// Reads sums, products and quotients of natural numbers and square roots of one of them, such as
/// `(1+sqrt(5))/2`, or the root of one such number, `sqrt((3+sqrt(5))/2)`, `10^(1/4)`: an algebraic
/// integer of at least 1. Throws `SyntaxError`.
AlgebraicInteger parse_surd(ClaimScanner& scanner);

}  // namespace algae
