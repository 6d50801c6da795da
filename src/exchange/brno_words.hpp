#pragma once

#include <set>

#include "exchange/brno_modules.hpp"
#include "exchange/placed_word.hpp"
#include "notation/findings.hpp"

namespace algae {

/// Adds a finding for each bracket of a word that has no other, for each cylinder and ball between
/// braces, and for each angle that the word needs and the file does not give, unless it is among
/// those that are `missing` already.
void check_brno_word(const PlacedWord& word, const BrnoSystem& system, std::set<char>& missing,
                     Findings& findings);

}  // namespace algae
