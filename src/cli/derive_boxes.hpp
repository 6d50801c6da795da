#pragma once

#include <cstdint>

#include "base/budget.hpp"
#include "system/lsystem.hpp"

namespace algae::cli {

/// Prints the boxes of the generations of a system of shape rules, a box a line, or one JSON object.
void derive_boxes(const LSystem& system, std::uint64_t first, std::uint64_t last, bool json,
                  const Budget& budget);

}  // namespace algae::cli
