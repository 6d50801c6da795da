#pragma once

#include "dimension/exact_dimension.hpp"

namespace algae {

/// The dimension of the limit curve of a parametric system whose rules multiply lengths by constants
/// (`RatioGraph`). Where all of them are the same, it is that of the D0L system with steps of one
/// length. Otherwise it is the similarity dimension (`RatioSum`), an upper bound, as whether parts
/// overlap is not looked at; segments that stay segments have the dimension 1.
///
/// Throws what `ratio_graph`, `WayGrowth` and `RatioSum` throw.
ExactDimension parametric_dimension(const LSystem& system, const Budget& budget = {});

}  // namespace algae
