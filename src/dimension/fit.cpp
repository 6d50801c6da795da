#include <fmt/format.h>

#include <algorithm>

#include "dimension/detail/measures.hpp"

// What counts and measures at several scales say of a dimension: a value and an interval.
//
// The dimension is the slope of the logarithm of the measure against that of the scale, in the
// limit of small scales; what can be measured is a finite range of scales. Three things go wrong
// there, and the fit handles each:
//
// - Coarse scales see the outer shape, fine ones single segments or points. Scales from an eighth
//   of the whole down to four details are used, or down to what holds enough points on average; of
//   these the seven finest.
// - Local slopes may drift. Where they rise from scale to scale, the value is what they tend to if
//   the rises shrink by a constant ratio (at most 0.8), and the interval holds the drift once more.
// - The slopes are not independent, so that the standard error of a regression is too small by far.
//   The interval is the range of the local slopes, widened by shares that were found by trial over
//   random curves of known dimension; tests/dimension measures how often it holds the true value.
//   Counts of a finite generation are too low rather than too high, so it is widened upward.
//
// `fit_dimension` is the fit for box counts, with its line for the plot; `fit_scaling` is that of
// all other measures.

namespace algae {

namespace {

constexpr double slowest = 0.8;  // ratio of successive rises, at most, for a limit
constexpr double hair = 1e-9;    // relative: roundings in sizes

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

/// Sets the scales of a fit, the finest of those that may be used. Returns how many may be.
template <class Fit, class MayBeUsed>
std::size_t choose_scales(Fit& fit, std::size_t scales, const MayBeUsed& may_be_used) {
    std::size_t usable = 0;
    for (std::size_t i = 0; i < scales; ++i) {
        if (!may_be_used(i)) continue;
        if (usable++ == 0) fit.first = i;
        fit.last = i;
    }
    if (usable >= ScaleRange::fewest)
        fit.first = std::max(fit.first, fit.last - std::min(fit.last, ScaleRange::most - 1));
    return usable;
}

/// Those between the scales that are used.
template <class Fit>
std::vector<double> slopes_used(const Fit& fit) {
    const auto begin = fit.slopes.begin();
    return {begin + static_cast<std::ptrdiff_t>(fit.first),
            begin + static_cast<std::ptrdiff_t>(fit.last)};
}

std::string slopes_text(const std::vector<double>& slopes, bool follow_rises) {
    const auto [least, greatest] = std::minmax_element(slopes.begin(), slopes.end());
    return fmt::format("; the slopes there lie between {:.3f} and {:.3f}{}", *least, *greatest,
                       follow_rises && still_rise(slopes)
                           ? " and still rise, so the value is what they tend to"
                           : "");
}

std::string why(const Scaling& scaling, const ScaleRange& range) {
    return fmt::format(
        "{} from {:.3g} down to {:.3g}: coarser ones see the outer shape, finer ones {}",
        range.scales, scaling.sizes[scaling.first], scaling.sizes[scaling.last],
        range.finer_ones_see);
}

std::string plural(const BoxCounts& counts, double how_many) {
    return fmt::format("{:.3g} ", how_many) + counts.part + (how_many == 1 ? "" : "s");
}

bool is_fine_enough(const BoxCounts& counts, std::size_t scale) {
    return counts.scales.cell(scale) * ScaleRange::parts_of_whole <=
           counts.scales.coarsest * (1 + hair);
}

bool is_coarse_enough(const BoxCounts& counts, std::size_t scale) {
    if (counts.scales.cell(scale) < ScaleRange::noises * counts.noise) return false;
    if (counts.detail > 0)
        return counts.scales.cell(scale) >= ScaleRange::details * counts.detail * (1 - hair);
    return counts.mean(scale) * ScaleRange::points_in_cell <= static_cast<double>(counts.parts);
}

//> line
void draw_line(BoxFit& fit, const BoxCounts& counts) {
    const double steps = static_cast<double>(fit.last - fit.first);
    fit.slope = std::log(counts.mean(fit.last) / counts.mean(fit.first)) /
                (steps * std::log(counts.scales.ratio));
    double sum = 0;
    for (std::size_t scale = fit.first; scale <= fit.last; ++scale)
        sum += std::log(counts.mean(scale)) + fit.slope * std::log(counts.scales.cell(scale));
    fit.intercept = sum / (steps + 1);
}
//< line

std::string finest_allowed(const BoxCounts& counts) {
    if (counts.noise > 0)
        return fmt::format("{:.0f} times {:.2g}, the standard deviation of the noise of the points",
                           ScaleRange::noises, counts.noise);
    if (counts.detail > 0) return plural(counts, ScaleRange::details);
    return "the cells that hold " + plural(counts, ScaleRange::points_in_cell) + " on average";
}

std::string why_not(const BoxCounts& counts, std::size_t usable) {
    const bool figure = counts.part == "segment";
    std::string text = figure             ? "the generation is too low: "
                       : counts.noise > 0 ? "too much noise: "
                                          : "too few " + counts.part + "s: ";
    text += (usable == 1 ? "1 scale lies" : std::to_string(usable) + " scales lie");
    text += " between an eighth of the whole and " + finest_allowed(counts) +
            ", expected at least " + std::to_string(ScaleRange::fewest);
    return figure ? text + "; draw a higher one, or more scales" : text;
}

std::string why(const BoxCounts& counts, const BoxFit& fit) {
    const auto size = [&](std::size_t scale) {
        return counts.detail > 0 ? plural(counts, counts.scales.cell(scale) / counts.detail)
                                 : fmt::format("1/{:.3g} of the whole",
                                               counts.scales.coarsest / counts.scales.cell(scale));
    };
    return "cells from " + size(fit.first) + " down to " + size(fit.last) +
           ": coarser ones see the outer shape, finer ones " +
           (counts.noise > 0 ? "the noise of the points" : "single " + counts.part + "s");
}

}  // namespace

bool still_rise(const std::vector<double>& slopes) {
    return slopes.size() >= 4 &&
           std::adjacent_find(slopes.begin(), slopes.end(), std::greater_equal<>()) == slopes.end();
}

std::vector<double> local_slopes(const BoxCounts& counts) {
    std::vector<double> slopes;
    const double step = std::log(counts.scales.ratio);
    for (std::size_t scale = 0; scale + 1 < counts.counts.size(); ++scale)
        slopes.push_back(std::log(counts.mean(scale + 1) / counts.mean(scale)) / step);
    return slopes;
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
    const std::size_t usable = choose_scales(scaling, sizes.size(), [&](std::size_t i) {
        return sizes[i] <= range.coarsest * (1 + hair) && sizes[i] >= range.finest * (1 - hair) &&
               std::isfinite(powers[i]);
    });
    if (usable < ScaleRange::fewest) {
        scaling.because = fmt::format(
            "too little to measure: {} of the {} {} between an eighth of the whole and {}, "
            "expected at least {}",
            usable, range.scales, usable == 1 ? "lies" : "lie", range.finest_is,
            ScaleRange::fewest);
        return;
    }
    const std::vector<double> slopes = slopes_used(scaling);
    const double slope = (powers[scaling.first] - powers[scaling.last]) /
                         std::log(sizes[scaling.first] / sizes[scaling.last]);
    widening.down /= static_cast<double>(slopes.size());
    widening.up /= static_cast<double>(slopes.size());
    scaling.estimate = estimate_from(slopes, slope, widening, most);
    if (!range.follow_rises) scaling.estimate->value = std::clamp(slope, 0.0, most);
    scaling.because = why(scaling, range) + slopes_text(slopes, range.follow_rises);
}

double BoxFit::fitted(const BoxCounts& counts, std::size_t scale) const {
    const double straight = intercept - slope * std::log(counts.scales.cell(scale));
    if (boundary == 0) return straight;
    return std::log(std::exp(straight) + boundary * std::pow(rate, static_cast<double>(scale)));
}

double BoxFit::residual(const BoxCounts& counts, std::size_t scale) const {
    return std::log(counts.mean(scale)) - fitted(counts, scale);
}

BoxFit fit_dimension(const BoxCounts& counts) {
    if (counts.counts.empty() || counts.counts.front().empty())
        throw Error("expected counts of at least one scale, found none");
    BoxFit fit;
    fit.slopes = local_slopes(counts);
    const std::size_t usable = choose_scales(fit, counts.counts.size(), [&](std::size_t scale) {
        return is_fine_enough(counts, scale) && is_coarse_enough(counts, scale);
    });
    if (usable < ScaleRange::fewest) {
        fit.because = why_not(counts, usable);
        return fit;
    }
    draw_line(fit, counts);
    const std::vector<double> slopes = slopes_used(fit);
    Widening widening;
    widening.up = Widening::upward / static_cast<double>(slopes.size());
    if (counts.detail > 0)
        widening.beyond = Widening::missed * counts.detail / counts.scales.cell(fit.last);
    fit.estimate = estimate_from(slopes, fit.slope, widening, counts.space);
    fit.because = why(counts, fit) + slopes_text(slopes, true);
    return fit;
}

}  // namespace algae
