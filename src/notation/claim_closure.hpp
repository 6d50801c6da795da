#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "claim/claim.hpp"
#include "claim/closure_table.hpp"
#include "notation/claim_reading.hpp"

namespace algae {

/// Whether a clause says what a claim settles in the table: `closed under ...`, `not closed under ...`.
bool is_closure_fact(std::string_view text);

/// What it says. Throws `SyntaxError`.
ClosureFact parse_closure_fact(std::string_view text, const ClaimReading& reading);

}  // namespace algae
