#pragma once

#include "exchange/brno_modules.hpp"
#include "exchange/placed_word.hpp"
#include "notation/findings.hpp"

namespace algae {

/// Adds a finding for each bracket of a word that has no other, for each cylinder and ball between
/// braces, and for each angle that the word needs and the file does not give.
void check_brno_word(const PlacedWord& word, const BrnoSystem& system, Findings& findings);

}  // namespace algae
