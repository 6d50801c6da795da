#pragma once

#include "base/budget.hpp"
#include "claim/claim.hpp"
#include "claim/judgement.hpp"

namespace algae {

/// Whether a system with parameters, probabilities or contexts of trees derives a word of modules in so
/// many steps: by deriving; where there are probabilities, whether the word has one above 0. Parameters
/// are numbers as Program computes them, and the same only where all their digits are. Throws what
/// Rewriting::next throws.
Judgement judge_rewriting(const Statement& statement, const Budget& budget = {});

/// Whether the word has exactly this probability in that generation (see distribution). Throws the same.
Judgement judge_chance(const Statement& statement, const Budget& budget = {});

}  // namespace algae
