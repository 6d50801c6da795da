#include "dimension/limit_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace algae {

namespace {

constexpr std::size_t longest_baseline = 3;  // in scales
constexpr double lost = 0.95;                // of the cells that the boundary term may take

/// The counts of places of a grid, with one of them left out or all.
class Means {
public:
    Means(const BoxCounts& counts, double rho) : counts_(counts), rho_(rho) {}

    static constexpr std::size_t nobody = ~std::size_t{0};

    /// The mean of n_j - rho n_(j-1).
    double combined(std::size_t scale, std::size_t without) const {
        return mean(scale, without) - (rho_ == 0 ? 0 : rho_ * mean(scale - 1, without));
    }
    double slope(std::size_t from, std::size_t to, std::size_t without = nobody) const {
        return std::log(combined(to, without) / combined(from, without)) /
               (static_cast<double>(to - from) * std::log(counts_.scales.ratio));
    }
    /// The standard error of a number got from all places, by leaving out one at a time.
    double error(const std::function<double(std::size_t)>& number) const {
        const std::size_t places = counts_.counts.front().size();
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < places; ++i) {
            const double value = number(i);
            sum += value;
            squares += value * value;
        }
        const double n = static_cast<double>(places);
        return std::sqrt(std::max(0.0, squares - sum * sum / n) * (n - 1) / n);
    }

private:
    double mean(std::size_t scale, std::size_t without) const {
        double sum = 0;
        const auto& all = counts_.counts[scale];
        for (std::size_t i = 0; i < all.size(); ++i)
            if (i != without) sum += static_cast<double>(all[i]);
        return sum / static_cast<double>(all.size() - (without == nobody ? 0 : 1));
    }

    const BoxCounts& counts_;
    double rho_;
};

/// What is measured above the bound stands at it.
Estimate interval(double value, double half, double bound) {
    const double within = std::min(value, bound);
    return {within, std::max(within - half, 0.0), std::min(value + half, bound)};
}

std::string short_text(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

/// With the boundary term taken out.
void fit_two_terms(const BoxCounts& counts, double rho, double bound, BoxFit& fit) {
    const Means means(counts, rho);
    const std::size_t last = counts.counts.size() - 1;
    double shortest = INFINITY;
    for (std::size_t baseline = 1; baseline <= longest_baseline && baseline + 2 <= last;
         ++baseline) {
        const double value = means.slope(last - baseline, last);
        const double before = means.slope(last - baseline - 1, last - 1);
        const double error =
            means.error([&](std::size_t i) { return means.slope(last - baseline, last, i); });
        const double half = 3 * error + std::abs(value - before) + 1e-5;
        if (!(half < shortest)) continue;
        shortest = half;
        fit.estimate = interval(value, half, bound);
        fit.first = last - baseline;
        fit.slope = value;
    }
    fit.last = last;
    // The two terms at the finest scale.
    const double whole =
        means.combined(last, Means::nobody) / (1 - rho * std::pow(counts.scales.ratio, -fit.slope));
    fit.intercept = std::log(whole) + fit.slope * std::log(counts.scales.cell(last));
    fit.rate = rho;
    fit.boundary = (counts.mean(last) - whole) / std::pow(rho, static_cast<double>(last));
    fit.because =
        "counted on the limit itself; slope over the finest scales of n_j - rho n_(j-1), with rho "
        "= " +
        short_text(rho) + " for each scale from the pairs of parts that meet";
}

/// By extrapolation of the local slopes.
void fit_slopes(const BoxCounts& counts, bool is_lost, double bound, BoxFit& fit) {
    const Means means(counts, 0);
    const std::size_t last = counts.counts.size() - 1;
    const double now = means.slope(last - 1, last), before = means.slope(last - 2, last - 1);
    const double earlier = means.slope(last - 3, last - 2);
    const double step = now - before, step_before = before - earlier;
    // Steps that shrink by a constant factor add up to step * factor / (1 - factor).
    double factor = step_before == 0 ? 0 : step / step_before;
    factor = std::clamp(factor, 0.0, 0.85);
    const double added = step * factor / (1 - factor);
    const double error = means.error([&](std::size_t i) { return means.slope(last - 1, last, i); });
    double half = std::abs(added) + std::abs(step) + 3 * error + 1e-4;
    if (is_lost) half = std::max(half, bound - now);
    fit.estimate = interval(now + added, half, bound);
    fit.first = last - 3;
    fit.last = last;
    fit.slope = now;
    fit.intercept = std::log(counts.mean(last)) + now * std::log(counts.scales.cell(last));
    fit.because =
        is_lost
            ? "counted on the limit itself; parts meet almost as often as they multiply, so the "
              "boundary cannot be told from the whole and the interval is wide"
            : "counted on the limit itself; local slopes extrapolated, because the rate at which "
              "parts meet is not known";
}

}  // namespace

BoxFit fit_limit(const LimitCounts& limit, const std::optional<Rate>& meeting, double bound) {
    const BoxCounts& counts = limit.boxes;
    BoxFit fit;
    for (std::size_t j = 0; j + 1 < counts.counts.size(); ++j)
        fit.slopes.push_back(std::log(counts.mean(j + 1) / counts.mean(j)) /
                             std::log(counts.scales.ratio));
    if (counts.counts.size() < 4) {
        fit.because =
            "too few scales: " + std::to_string(counts.counts.size()) + ", expected at least 4";
        return fit;
    }
    const std::size_t last = counts.counts.size() - 1;
    const double rho =
        meeting ? std::pow(meeting->enclosure(64).midpoint(), static_cast<double>(limit.levels))
                : 0;
    const bool is_lost = meeting && rho * counts.mean(last - 1) > lost * counts.mean(last);
    if (meeting && !is_lost)
        fit_two_terms(counts, rho, bound, fit);
    else
        fit_slopes(counts, is_lost, bound, fit);
    return fit;
}

LimitMeasure measure_limit(const ExactDimension& exact, LimitCounting counting,
                           const Budget& budget) {
    counting.coinciding = exact.value->text() != exact.similarity->text();
    if (counting.coinciding) counting.most_cells /= 2;
    LimitCounts counts = limit_counts(*exact.limit, counting, budget);
    BoxFit fit = fit_limit(counts, exact.meeting, greatest_dimension(exact));
    return {std::move(counts), std::move(fit)};
}

}  // namespace algae
