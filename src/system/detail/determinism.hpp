#pragma once

#include <cstddef>
#include <vector>

#include "system/system.hpp"

namespace algae {

/// The first pairs of rules that `overlaps` finds, at most so many.
std::vector<RuleOverlap> first_overlaps(const LSystem& system, std::size_t most);

}  // namespace algae
