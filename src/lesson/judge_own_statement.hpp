#pragma once

#include "base/budget.hpp"
#include "claim/judgement.hpp"
#include "lesson/own_statement.hpp"
#include "notation/read_claim.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// Whether a statement of an exercise's own holds of the system. `open` knows the systems that figures are compared with.
/// Refuted with what the answer has instead. Throws what `open` and `outline` throw.
Judgement judge_own_statement(const OwnStatement& asked, const LSystem& answer,
                              const SystemSource& open, const Budget& budget = {});

}  // namespace algae
