#pragma once

#include "base/budget.hpp"
#include "claim/claim.hpp"
#include "claim/judgement.hpp"

namespace algae {

/// Whether the limit set that the system draws has this dimension, or one at most as large: by
/// `exact_dimension`, and exactly. Where the rules give an upper bound only, nothing below it is said
/// to be the dimension, nor that it is one. Undecided with the reasons where the rules give no
/// formula, and where two logarithms agree in 200 digits but no proof of their equality was found.
Judgement judge_dimension(const LSystem& system, const ClaimedDimension& claimed,
                          const Budget& budget = {});

/// The same of the boundary of a limit set with interior points.
Judgement judge_boundary(const LSystem& system, const ClaimedDimension& claimed,
                         const Budget& budget = {});

}  // namespace algae
