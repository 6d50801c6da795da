#include "dimension/scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace algae {

namespace {

constexpr double hair = 1e-9;  // relative: roundings in sizes

std::string why(const Scaling& scaling, const ScaleRange& range,
                const std::vector<double>& slopes) {
    const auto [least, greatest] = std::minmax_element(slopes.begin(), slopes.end());
    std::string text = fmt::format(
        "{} from {:.3g} down to {:.3g}: coarser ones see the outer shape, finer ones {}; the "
        "slopes there lie between {:.3f} and {:.3f}",
        range.scales, scaling.sizes[scaling.first], scaling.sizes[scaling.last],
        range.finer_ones_see, *least, *greatest);
    if (range.follow_rises && still_rise(slopes))
        text += " and still rise, so the value is what they tend to";
    return text;
}

}  // namespace

std::vector<double> halved_sizes(double whole, double detail, std::size_t most) {
    std::vector<double> sizes;
    for (double size = whole; sizes.size() < most && size >= detail * (1 - hair); size /= 2)
        sizes.push_back(size);
    return sizes;
}

void fit_scaling(Scaling& scaling, const std::vector<double>& powers, const ScaleRange& range,
                 Widening widening, double most) {
    const std::vector<double>& sizes = scaling.sizes;
    if (powers.empty() || powers.size() != sizes.size())
        throw Error(
            fmt::format("expected one value for each of at least one scale, found {} for {}",
                        powers.size(), sizes.size()));
    scaling.slopes.clear();
    for (std::size_t i = 0; i + 1 < sizes.size(); ++i)
        scaling.slopes.push_back((powers[i] - powers[i + 1]) / std::log(sizes[i] / sizes[i + 1]));
    std::size_t usable = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        if (sizes[i] > range.coarsest * (1 + hair) || sizes[i] < range.finest * (1 - hair) ||
            !std::isfinite(powers[i]))
            continue;
        if (usable++ == 0) scaling.first = i;
        scaling.last = i;
    }
    if (usable < ScaleRange::fewest) {
        scaling.because = fmt::format(
            "too little to measure: {} of the {} {} between an eighth of the whole and {}, "
            "expected at least {}",
            usable, range.scales, usable == 1 ? "lies" : "lie", range.finest_is,
            ScaleRange::fewest);
        return;
    }
    scaling.first =
        std::max(scaling.first, scaling.last - std::min(scaling.last, ScaleRange::most - 1));
    const auto begin = scaling.slopes.begin();
    const std::vector<double> slopes(begin + static_cast<std::ptrdiff_t>(scaling.first),
                                     begin + static_cast<std::ptrdiff_t>(scaling.last));
    const double slope = (powers[scaling.first] - powers[scaling.last]) /
                         std::log(sizes[scaling.first] / sizes[scaling.last]);
    widening.down /= static_cast<double>(slopes.size());
    widening.up /= static_cast<double>(slopes.size());
    scaling.estimate = estimate_from(slopes, slope, widening, most);
    if (!range.follow_rises) scaling.estimate->value = std::clamp(slope, 0.0, most);
    scaling.because = why(scaling, range, slopes);
}

}  // namespace algae
