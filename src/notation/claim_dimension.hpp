#pragma once

#include "claim/claim.hpp"
#include "notation/claim_reading.hpp"
#include "notation/claim_scanner.hpp"

namespace algae {

/// Reads what is said of the dimension of the limit set that a system draws, or of its boundary,
/// `dimension(G) = log 4 / log 3`, into the statement. Throws `SyntaxError` or `DependsOnError`.
void parse_dimension(ClaimScanner& scanner, Statement& statement, ClaimReading& reading);

}  // namespace algae
