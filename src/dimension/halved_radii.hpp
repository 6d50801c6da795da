#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "dimension/points.hpp"
#include "dimension/scaling.hpp"

namespace algae {

/// How many of `count` radii, the first one `greatest` and each half of the one before, are at least
/// `distance`. The same as comparing with each, and quicker.
///
/// Example: halved_radii(8, 2, 20) == 3
inline std::size_t halved_radii(double greatest, double distance, std::size_t count) {
    if (!(distance <= greatest)) return 0;
    if (!(distance > 0)) return count;
    int at_most = 0, bound = 0;
    const double whole = std::frexp(greatest, &at_most), part = std::frexp(distance, &bound);
    const auto halvings = static_cast<std::size_t>(at_most - bound - (part > whole ? 1 : 0));
    return halvings < count ? halvings + 1 : count;
}

/// The radii that points can say something at: those with at least four other points within them on
/// average and of at least four points' size. `means` falls with the radii.
ScaleRange points_range(const PointSet& points, const std::vector<double>& radii,
                        const std::vector<double>& means, const std::string& scales);

}  // namespace algae
