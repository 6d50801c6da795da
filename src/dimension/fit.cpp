#include "dimension/fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/error.hpp"

namespace algae {

namespace {

constexpr double parts_of_whole = 8;   // the coarsest cell used is this share of the coarsest one
constexpr double details_in_cell = 4;  // the finest cell used holds so many segments in a row
constexpr double points_in_cell = 8;
constexpr std::size_t fewest_scales = 4, most_scales = 7;
constexpr double upward =
    4.5;  // share of the slopes' range by which counts may be too low, times slopes
constexpr double missed =
    0.05;  // by how much a slope is too low where a cell is one detail wide, at most
constexpr double hair = 1e-9;    // relative: roundings in the widths of cells

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string slope_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
    return text;
}

std::string plural(const BoxCounts& counts, double how_many) {
    return short_number(how_many) + " " + counts.part + (how_many == 1 ? "" : "s");
}

bool is_fine_enough(const BoxCounts& counts, std::size_t scale) {
    return counts.scales.cell(scale) * parts_of_whole <= counts.scales.coarsest * (1 + hair);
}

bool is_coarse_enough(const BoxCounts& counts, std::size_t scale) {
    if (counts.detail > 0)
        return counts.scales.cell(scale) >= details_in_cell * counts.detail * (1 - hair);
    return counts.mean(scale) * points_in_cell <= static_cast<double>(counts.parts);
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
    if (counts.detail > 0) return plural(counts, details_in_cell);
    return "the cells that hold " + plural(counts, points_in_cell) + " on average";
}

std::string why_not(const BoxCounts& counts, std::size_t usable) {
    const bool figure = counts.part == "segment";
    std::string text = figure ? "the generation is too low: " : "too few " + counts.part + "s: ";
    text += (usable == 1 ? "1 scale lies" : std::to_string(usable) + " scales lie");
    text += " between an eighth of the whole and " + finest_allowed(counts) +
            ", expected at least " + std::to_string(fewest_scales);
    return text + (figure ? "; draw a higher one, or more scales" : "");
}

std::string why(const BoxCounts& counts, const BoxFit& fit, const std::vector<double>& slopes) {
    const auto size = [&](std::size_t scale) {
        return counts.detail > 0
                   ? plural(counts, counts.scales.cell(scale) / counts.detail)
                   : "1/" + short_number(counts.scales.coarsest / counts.scales.cell(scale)) +
                         " of the whole";
    };
    const auto [least, greatest] = std::minmax_element(slopes.begin(), slopes.end());
    std::string text = "cells from " + size(fit.first) + " down to " + size(fit.last) +
                       ": coarser ones see the outer shape, finer ones single " + counts.part +
                       "s; the slopes there lie between " + slope_number(*least) + " and " +
                       slope_number(*greatest);
    if (still_rise(slopes)) text += " and still rise, so the value is what they tend to";
    return text;
}

}  // namespace

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
    const double step = std::log(counts.scales.ratio);
    for (std::size_t scale = 0; scale + 1 < counts.counts.size(); ++scale)
        fit.slopes.push_back(std::log(counts.mean(scale + 1) / counts.mean(scale)) / step);
    std::size_t usable = 0;
    for (std::size_t scale = 0; scale < counts.counts.size(); ++scale) {
        if (!is_fine_enough(counts, scale) || !is_coarse_enough(counts, scale)) continue;
        if (usable++ == 0) fit.first = scale;
        fit.last = scale;
    }
    if (usable < fewest_scales) {
        fit.because = why_not(counts, usable);
        return fit;
    }
    fit.first = std::max(fit.first, fit.last - std::min(fit.last, most_scales - 1));
    draw_line(fit, counts);
    const std::vector<double> slopes(fit.slopes.begin() + static_cast<std::ptrdiff_t>(fit.first),
                                     fit.slopes.begin() + static_cast<std::ptrdiff_t>(fit.last));
    Widening widening;
    widening.up = upward / static_cast<double>(slopes.size());
    if (counts.detail > 0) widening.beyond = missed * counts.detail / counts.scales.cell(fit.last);
    fit.estimate = estimate_from(slopes, fit.slope, widening, counts.space);
    fit.because = why(counts, fit, slopes);
    return fit;
}

}  // namespace algae
