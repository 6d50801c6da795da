#pragma once

#include <cstdint>
#include <utility>

#include "base/budget.hpp"
#include "system/il.hpp"

namespace algae::cli {

/// Prints the lengths of a system with interactions, derived one generation after the other: there
/// is no matrix, and nothing is fitted.
int growth_interaction(const IL& system, std::pair<std::uint64_t, std::uint64_t> generations, bool json,
                       const Budget& budget);

}  // namespace algae::cli
