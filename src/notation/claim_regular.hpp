#pragma once

#include "notation/claim_reading.hpp"
#include "notation/claim_scanner.hpp"

namespace algae {

/// Reads the regular expression between slashes that stands next, `/a(aa)*|b?/`, as a language: letters next
/// to each other are one word, choices of words one finite set. Throws `SyntaxError`. Brackets nest at
/// most 200 deep, operations 1000. Linear.
LanguageOperand parse_regular(ClaimScanner& scanner, ClaimReading& reading);

}  // namespace algae
