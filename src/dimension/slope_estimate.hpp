#pragma once

#include <vector>

namespace algae {

/// A number that was measured, and the interval in which the true one is expected.
struct Estimate {
    double value = 0, low = 0, high = 0;
};

/// Whether there are at least four slopes and each is greater than the one before.
///
/// Example: still_rise({1.1, 1.2, 1.25, 1.27})
bool still_rise(const std::vector<double>& slopes);

/// How an interval is widened beyond the slopes: by these shares of their range, and upward by
/// `beyond` once more.
struct Widening {
    double down = 0, up = 0, beyond = 0;
};

/// What local slopes, from the coarsest scale to the finest, say of the slope of the limit. The
/// value is `slope`, that over all scales, or what the slopes tend to where they still rise and
/// the rises go on shrinking as they do. The interval holds all slopes and what their trend adds
/// once more, and is widened. At least one slope is needed. Nothing is below 0 or above `most`.
Estimate estimate_from(const std::vector<double>& slopes, double slope, const Widening& widening,
                       double most);

}  // namespace algae
