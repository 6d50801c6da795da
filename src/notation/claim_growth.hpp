#pragma once

#include "exact/integer.hpp"
#include "claim/claim.hpp"
#include "notation/claim_reading.hpp"
#include "notation/claim_scanner.hpp"

namespace algae {

/// Reads what is said of the sequence or the growth of systems, `growth(G) = 2^n`, into the statement.
/// Throws `SyntaxError` or `DependsOnError`.
void parse_growth(ClaimScanner& scanner, Statement& statement, ClaimReading& reading);

/// Reads a natural number of at most a thousand digits; `what` it is for. Throws `SyntaxError`.
Integer parse_number(ClaimScanner& scanner, const char* what);

}  // namespace algae
