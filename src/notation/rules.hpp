#pragma once

#include "notation/reading.hpp"

namespace algae {

/// Reads a rule into the system. Throws `SyntaxError`.
void read_rule(const Clause& clause, Reading& reading);

/// Reads `interpret L -> F` into the system. Throws `SyntaxError`.
void read_interpretation(const Clause& clause, Reading& reading);

/// Adds a finding for each left side whose rules have probabilities that do not add up to 1, or for
/// which only some rules have one.
void check_probabilities(const std::vector<Production>& rules, Reading& reading);

}  // namespace algae
