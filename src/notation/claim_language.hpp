#pragma once

#include "notation/claim_reading.hpp"
#include "notation/claim_scanner.hpp"

namespace algae {

/// Reads one language expression, up to where it cannot go on. Where `between_bars`, a `|` with `=` behind
/// it ends the expression, as in `|A| = 3`. Throws `SyntaxError` or `DependsOnError`. Linear, but for
/// the letters that images and complements are about; brackets nest at most 200 deep, operations 1000.
LanguageOperand parse_language(ClaimScanner& scanner, ClaimReading& reading,
                               bool between_bars = false);

}  // namespace algae
