#include "dimension/slope_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace algae {

namespace {

constexpr double slowest = 0.8;  // ratio of successive rises, at most, for a limit

/// What slopes tend to that rise from scale to scale, if the rises shrink by a constant ratio.
double limit_of(const std::vector<double>& slopes) {
    const std::size_t n = slopes.size();
    const double rise = slopes[n - 1] - slopes[n - 2], before = slopes[n - 3] - slopes[n - 4];
    const double ratio = std::min(std::sqrt(rise / before), slowest);  // per scale: two lie between
    return slopes.back() + rise * ratio / (1 - ratio);
}

/// By how much the slopes rise over the scales: the last two against the first two.
double trend(const std::vector<double>& slopes) {
    const std::size_t n = slopes.size();
    if (n < 4) return slopes.back() - slopes.front();
    return (slopes[n - 1] + slopes[n - 2] - slopes[0] - slopes[1]) / 2;
}

}  // namespace

bool still_rise(const std::vector<double>& slopes) {
    return slopes.size() >= 4 &&
           std::adjacent_find(slopes.begin(), slopes.end(), std::greater_equal<>()) == slopes.end();
}

Estimate estimate_from(const std::vector<double>& slopes, double slope, const Widening& widening,
                       double most) {
    const auto [least, greatest] = std::minmax_element(slopes.begin(), slopes.end());
    const double way = trend(slopes), range = *greatest - *least;
    Estimate found;
    found.value = still_rise(slopes) ? limit_of(slopes) : slope;
    found.low = *least + std::min(way, 0.0) - widening.down * range;
    found.high = *greatest + std::max(way, 0.0) + widening.up * range + widening.beyond;
    found.value = std::clamp(found.value, 0.0, most);
    found.low = std::clamp(found.low, 0.0, found.value);
    found.high = std::clamp(found.high, found.value, most);
    return found;
}

}  // namespace algae
