#pragma once

#include "base/budget.hpp"
#include "system/lsystem.hpp"

namespace algae::cli {

/// Prints what the words of a D0L system have in common: factor complexity and its class, pushiness,
/// repetitions, a locally catenative formula. Throws Error if the system is not D0L. Returns the
/// exit status: 3 if the class is not decided.
int growth_words(const LSystem& system, bool json, const Budget& budget);

}  // namespace algae::cli
