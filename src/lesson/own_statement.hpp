#pragma once

#include <string>

#include "base/budget.hpp"
#include "claim/judgement.hpp"
#include "lesson/exercise.hpp"
#include "notation/read_claim.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// Whether a statement of an exercise's own holds of the system. `open` knows the systems that figures are compared with.
/// Refuted with what the answer has instead. Throws Error where the statement cannot be read, and what
/// `outline` throws.
Judgement judge_own_statement(const Demand& demand, const LSystem& answer, const SystemSource& open,
                              const Budget& budget = {});

}  // namespace algae
