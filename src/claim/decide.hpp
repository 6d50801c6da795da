#pragma once

#include "base/budget.hpp"
#include "claim/claim.hpp"
#include "claim/judgement.hpp"

namespace algae {

/// What is known of a statement of a claim. A bound that is reached makes it undecided, and the judgement says
/// which. Throws Interrupted if the work was asked to stop, Error where the statement cannot be about its systems.
Judgement decide(const Statement& statement, const Claim& claim, const Budget& budget = {});

}  // namespace algae
