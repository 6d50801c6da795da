#include "dimension/halved_radii.hpp"

#include <algorithm>

namespace algae {

namespace {

constexpr double fewest_neighbours = 4;

}  // namespace

ScaleRange points_range(const PointSet& points, const std::vector<double>& radii,
                        const std::vector<double>& means, const std::string& scales) {
    ScaleRange range{HUGE_VAL, radii.front()};
    for (std::size_t i = 0; i < radii.size() && means[i] >= fewest_neighbours; ++i)
        range.finest = radii[i];
    range.finest = std::max(range.finest, ScaleRange::details * points.detail);
    range.scales = scales;
    range.finest_is = "those with 4 other " + points.part + "s within them on average";
    if (points.detail > 0) range.finest_is += " and 4 times the size of a detail";
    range.finer_ones_see = "single " + points.part + "s";
    return range;
}

}  // namespace algae
