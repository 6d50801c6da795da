#pragma once

#include <optional>

#include "dimension/ratio_graph.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// The D0L system that draws the same figures with steps of the length 1, where every rule multiplies
/// lengths by the same number and turns stay as they are: only the size of figures differs.
std::optional<LSystem> with_equal_lengths(const RatioGraph& graph);

}  // namespace algae
