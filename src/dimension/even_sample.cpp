#include "dimension/even_sample.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "dimension/drawn_segments.hpp"

namespace algae {

namespace {

/// A number from 0 to 1, without 1; the distributions of the standard library differ by machine.
double share(std::mt19937_64& random) {
    return std::ldexp(static_cast<double>(random() >> 11), -53);
}

/// So many places between 0 and 1, in order.
std::vector<double> places(std::size_t count, Spread spread, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<double> all;
    all.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        all.push_back(spread == Spread::independent
                          ? share(random)
                          : (static_cast<double>(i) + share(random)) / static_cast<double>(count));
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

PointSet even_sample(const Figure& figure, std::size_t count, Spread spread, std::uint64_t seed,
                     const Budget& budget) {
    double whole = 0;
    DrawnSegments ruler(
        [&](Point from, Point to, bool) { whole += std::hypot(to.x - from.x, to.y - from.y); });
    figure.draw(ruler, 0, budget);
    if (!(whole > 0) || !std::isfinite(whole))
        throw Error("expected strokes with a length to measure, found a length of " +
                    std::to_string(whole));
    PointSet sample;
    sample.detail = figure.facts().step;
    budget.check_memory(count * (sizeof(sample.points[0]) + sizeof(double)),
                        "the points of a sample");
    sample.points.reserve(count);
    const std::vector<double> shares = places(count, spread, seed);
    double done = 0;
    DrawnSegments picker([&](Point from, Point to, bool) {
        const double length = std::hypot(to.x - from.x, to.y - from.y);
        while (sample.points.size() < count) {
            const double part = (shares[sample.points.size()] * whole - done) / length;
            if (!(part < 1)) break;
            sample.points.push_back(
                {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y), 0});
        }
        done += length;
    });
    figure.draw(picker, 0, budget);
    return sample;
}

PointSet even_sample(const PointSet& points, std::size_t count, std::uint64_t seed) {
    if (points.points.size() <= count) return points;
    PointSet sample = points;
    sample.points.clear();
    std::mt19937_64 random(seed);
    for (std::size_t i = 0; i < points.points.size(); ++i) {
        const auto left = static_cast<double>(points.points.size() - i);
        if (left * share(random) < static_cast<double>(count - sample.points.size()))
            sample.points.push_back(points.points[i]);
    }
    return sample;
}

}  // namespace algae
