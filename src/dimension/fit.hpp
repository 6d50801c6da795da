#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dimension/box_counts.hpp"
#include "dimension/slope_estimate.hpp"

namespace algae {

/// What box counts say of the dimension of the shape that a figure, an image or points stand for.
struct BoxFit {
    /// Between each scale and the next finer one: how fast the mean count grows with 1 / cell.
    std::vector<double> slopes;
    /// The scales that were used: those from `first` to `last`, both included.
    std::size_t first = 0, last = 0;
    /// Nothing if there are too few of them.
    std::optional<Estimate> estimate;
    /// The line through these scales in the plot: the mean count of scale j is about
    /// exp(intercept) / cell^slope + boundary * rate^j; it is straight without a boundary.
    double slope = 0, intercept = 0;
    double boundary = 0, rate = 1;
    /// Which scales and why, in one sentence; or why nothing can be said.
    std::string because;

    /// The natural logarithm of the mean count that the line gives for a scale.
    double fitted(const BoxCounts& counts, std::size_t scale) const;
    /// How far the logarithm of the mean count is above the line.
    double residual(const BoxCounts& counts, std::size_t scale) const;
};

/// Fits the dimension. Scales are used that are at most an eighth of the whole, so that its outer
/// shape does not decide, and at least four details (segments, pixels) wide; for points, which have
/// no size, as long as eight points fall into a cell on average. Of these, the seven finest.
///
/// The estimate is the slope over these scales; where the local slopes rise from scale to scale, what
/// they tend to if the rises go on shrinking as they do. The interval holds all local slopes and what
/// their trend adds once more; and upward, because counts of a finite generation are too low rather
/// than too high, 4.5 / slopes of their range and 1/20 of detail / finest cell. It is no standard
/// error: those of a regression on counts are too small by far. tests/dimension measures how often it
/// holds the true value over random curves. O(scales * offsets).
///
/// With fewer than four scales to use, there is no estimate, and `because` says what would help.
BoxFit fit_dimension(const BoxCounts& counts);

}  // namespace algae
