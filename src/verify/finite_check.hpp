#pragma once

#include <optional>
#include <string>

#include "base/budget.hpp"
#include "verify/finite_obstruction.hpp"

namespace algae {

/// What is wrong with a proof that a finite language is not of a family, in words; nothing if it
/// proves that. Checks every step anew, on words and sets of words: it knows nothing of the search.
/// Exponential in the worst case; throws BoundReached where it takes more than the budget.
///
/// Example: flaw_in(*decide_family(finite_language({"a", "aa"}), Family{}).obstruction) == std::nullopt
std::optional<std::string> flaw_in(const FamilyObstruction& obstruction, const Budget& budget = {});

}  // namespace algae
