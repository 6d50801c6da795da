#pragma once

#include <vector>

#include "exact/integer.hpp"
#include "turtle/commands.hpp"

namespace algae {

/// How many segments a word draws in which `letters[i]` occurs `counts[i]` times, wherever they
/// stand; with cut branches (`%`) at most as many. O(letters).
Integer drawn_segments(const Commands& commands, const std::vector<Symbol>& letters,
                       const std::vector<Integer>& counts);

}  // namespace algae
