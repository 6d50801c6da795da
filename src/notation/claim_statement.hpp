#pragma once

#include <string_view>

#include "claim/claim.hpp"
#include "notation/claim_reading.hpp"

namespace algae {

/// The statement that is the whole of the text: `A is not 0L`, `A == B`, `a in A`, `|A| = 3`,
/// `G ==> aab in 3 steps`, `growth(G) ~ exponential`, ... Throws `SyntaxError` or `DependsOnError`.
Statement parse_statement(std::string_view text, ClaimReading& reading);

/// Reads `G ==> W in 3 steps` or `G : U ==> W`. Throws `SyntaxError`.
void parse_derivation(std::string_view text, Statement& statement, ClaimReading& reading);

}  // namespace algae
