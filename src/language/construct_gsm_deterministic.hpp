#pragma once

#include "base/budget.hpp"
#include "language/gsm.hpp"
#include "system/et0l.hpp"

namespace algae {

/// What a deterministic machine writes when it reads words of a deterministic system, by a deterministic
/// system: how and at what cost stands with `table_gsm_image`, the function to use. Throws Error if one
/// of the two is nondeterministic, and what `table_gsm_image` throws.
ET0L deterministic_gsm_image(const ET0L& system, const Gsm& machine, const Budget& budget = {});

}  // namespace algae
