#include "nature/brownian.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <map>

#include "base/error.hpp"
#include "nature/fourier.hpp"

namespace algae {

void check_parameters(const BrownianMotion& motion) {
    if (!(motion.hurst > 0 && motion.hurst < 1))
        throw Error(
            fmt::format("hurst: expected a number between 0 and 1, found {}", motion.hurst));
    if (!(motion.sigma > 0) || !std::isfinite(motion.sigma))
        throw Error(fmt::format("sigma: expected a number above 0, found {}", motion.sigma));
    if (motion.levels < 0 || motion.levels > BrownianMotion::most_levels)
        throw Error(fmt::format("levels: expected 0 to {}, found {}", BrownianMotion::most_levels,
                                motion.levels));
}

double displacement_variance(const BrownianMotion& motion, int level) {
    return motion.sigma * motion.sigma * std::exp2(-2 * motion.hurst * level) *
           (1 - std::exp2(2 * motion.hurst - 2));
}

std::vector<double> midpoint_path(const BrownianMotion& motion, const Gaussians& numbers,
                                  const Budget& budget) {
    check_parameters(motion);
    const std::size_t pieces = std::size_t{1} << motion.levels;
    budget.check_memory((pieces + 1) * sizeof(double), "a path");
    std::vector<double> path(pieces + 1);
    path[pieces] = motion.sigma * numbers.at(0);
    for (int level = 1; level <= motion.levels; ++level) {
        budget.check();
        const double deviation = std::sqrt(displacement_variance(motion, level));
        const std::size_t half = pieces >> level;  // from a midpoint to its neighbours
        std::uint64_t number = std::uint64_t{1} << (level - 1);
        for (std::size_t i = half; i < pieces; i += 2 * half)
            path[i] = (path[i - half] + path[i + half]) / 2 + deviation * numbers.at(number++);
    }
    return path;
}

double midpoint_increment_variance(const BrownianMotion& motion, std::uint64_t from,
                                   std::uint64_t to) {
    check_parameters(motion);
    const std::uint64_t pieces = std::uint64_t{1} << motion.levels;
    if (from > pieces || to > pieces)
        throw Error(
            fmt::format("expected values 0 to {} of a path, found {} and {}", pieces, from, to));
    // The increment as a sum of values times factors; at most four of them at every level.
    std::map<std::uint64_t, double> factors;
    factors[to] += 1;
    factors[from] -= 1;
    double variance = 0;
    for (int level = motion.levels; level >= 1; --level) {
        std::map<std::uint64_t, double> above;
        for (const auto& [place, factor] : factors) {
            if (place % 2 == 0) {
                above[place / 2] += factor;
                continue;
            }
            variance += factor * factor * displacement_variance(motion, level);
            above[place / 2] += factor / 2;
            above[place / 2 + 1] += factor / 2;
        }
        factors = std::move(above);
    }
    return variance + factors[1] * factors[1] * motion.sigma * motion.sigma;
}

double increment_covariance(double hurst, std::uint64_t lag) {
    const double exponent = 2 * hurst, k = static_cast<double>(lag);
    if (lag == 0) return 1;
    if (lag < 16)
        return (std::pow(k + 1, exponent) + std::pow(k - 1, exponent)) / 2 - std::pow(k, exponent);
    // k^(2H) times the even part of the binomial series in 1/k, without its first term.
    double term = 1, sum = 0;
    for (int j = 1; j <= 8; ++j) {
        term *=
            (exponent - (2 * j - 2)) * (exponent - (2 * j - 1)) / ((2 * j - 1) * (2 * j) * k * k);
        sum += term;
    }
    return std::pow(k, exponent) * sum;
}

std::vector<double> exact_path(const BrownianMotion& motion, const Gaussians& numbers,
                               const Budget& budget) {
    check_parameters(motion);
    const std::size_t steps = std::size_t{1} << motion.levels, around = 2 * steps;
    budget.check_memory(5 * around * sizeof(std::complex<double>), "a path");
    std::vector<std::complex<double>> values(around);
    for (std::size_t lag = 0; lag <= steps; ++lag) {
        if (lag % 4096 == 0) budget.check();
        values[lag] = increment_covariance(motion.hurst, lag);
        if (lag > 0 && lag < steps) values[around - lag] = values[lag];
    }
    values = fourier_transform(values);
    for (std::size_t k = 0; k < around; ++k) {
        if (k % 4096 == 0) budget.check();
        const double share = std::max(values[k].real(), 0.0) / static_cast<double>(around);
        values[k] = std::sqrt(share) * std::complex(numbers.at(2 * k), numbers.at(2 * k + 1));
    }
    budget.check();
    values = fourier_transform(values);
    const double scale = motion.sigma * std::exp2(-motion.hurst * motion.levels);
    std::vector<double> path(steps + 1);
    for (std::size_t i = 0; i < steps; ++i) path[i + 1] = path[i] + scale * values[i].real();
    return path;
}

double estimated_hurst(const std::vector<double>& path) {
    if (path.size() < 6)
        throw Error(fmt::format("expected a path of at least 6 values, found {}", path.size()));
    const auto mean_square = [&](std::size_t step) {
        double sum = 0;
        const std::size_t count = path.size() - 2 * step;
        for (std::size_t i = 0; i < count; ++i) {
            const double second = path[i + 2 * step] - 2 * path[i + step] + path[i];
            sum += second * second;
        }
        return sum / static_cast<double>(count);
    };
    const double near = mean_square(1), far = mean_square(2);
    if (!(near > 0 && far > 0)) throw Error("expected a rough path, found values on a line");
    return std::log2(far / near) / 2;
}

}  // namespace algae
