#include "dimension/correlation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "dimension/even_sample.hpp"
#include "dimension/halved_radii.hpp"

namespace algae {

namespace {

constexpr std::size_t most_scales = 20;

using Cell = std::array<std::int64_t, 3>;

/// Points in the order of their cells.
struct Celled {
    Cell cell;
    std::array<double, 3> point;
};

Cell cell_of(const std::array<double, 3>& point, const std::array<double, 3>& low, double width) {
    Cell cell{};
    for (std::size_t i = 0; i < 3; ++i)
        cell[i] = static_cast<std::int64_t>(std::floor((point[i] - low[i]) / width));
    return cell;
}

bool by_cell(const Celled& a, const Celled& b) { return a.cell < b.cell; }

}  // namespace

std::vector<std::uint64_t> near_pairs(const PointSet& set, double greatest, std::size_t radii,
                                      const Budget& budget) {
    if (!(greatest > 0))
        throw Error("expected a radius above 0, found " + std::to_string(greatest));
    budget.check_memory(set.points.size() * sizeof(Celled), "the points in their cells");
    std::array<double, 3> low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
    for (const auto& point : set.points)
        for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], point[i]);
    // A hair wider, so that no rounding puts two points this near into cells further apart.
    const double width = greatest * (1 + 1e-6);
    std::vector<Celled> points;
    points.reserve(set.points.size());
    for (const auto& point : set.points) points.push_back({cell_of(point, low, width), point});
    std::sort(points.begin(), points.end(), by_cell);

    std::vector<std::uint64_t> pairs(radii);
    const auto compare = [&](std::size_t i, std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t within =
                halved_radii(greatest, distance(points[i].point, points[k].point), radii);
            if (within > 0) ++pairs[within - 1];
        }
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % 256 == 0) budget.check();
        // Three cells that follow each other are one stretch of the list. Every pair is seen from the
        // point that comes first.
        for (std::int64_t column = 0; column <= 1; ++column)
            for (std::int64_t row = column == 0 ? 0 : -1; row <= 1; ++row) {
                Celled from = points[i], to = points[i];
                from.cell[0] += column, to.cell[0] += column;
                from.cell[1] += row, to.cell[1] += row;
                from.cell[2] -= 1, to.cell[2] += 1;
                const auto begin = std::lower_bound(points.begin(), points.end(), from, by_cell);
                const auto end = std::upper_bound(begin, points.end(), to, by_cell);
                const auto first = static_cast<std::size_t>(begin - points.begin());
                compare(i, std::max(first, i + 1), static_cast<std::size_t>(end - points.begin()));
            }
    }
    for (std::size_t i = radii; i-- > 1;) pairs[i - 1] += pairs[i];
    return pairs;
}

Scaling correlation(const PointSet& all, const CorrelationSample& sample, const Budget& budget) {
    if (all.points.size() < 2 || sample.points < 2)
        throw Error("expected at least 2 points to take the distance of, found " +
                    std::to_string(std::min(all.points.size(), sample.points)));
    const PointSet points = even_sample(all, sample.points, sample.seed);
    const double coarsest = longest_side(points) / ScaleRange::parts_of_whole;
    Scaling result;
    result.sizes = halved_sizes(coarsest, std::min(points.detail, coarsest), most_scales);
    const auto pairs = near_pairs(points, coarsest, result.sizes.size(), budget);
    const double count = static_cast<double>(points.points.size());
    std::vector<double> neighbours, powers;
    for (const std::uint64_t pair : pairs) {
        const double share = 2 * static_cast<double>(pair) / (count * (count - 1));
        result.values.push_back(share);
        powers.push_back(std::log(share));
        neighbours.push_back(share * (count - 1));
    }
    fit_scaling(result, powers, points_range(points, result.sizes, neighbours, "radii"), {1, 1, 0},
                points.columns);
    return result;
}

Scaling correlation(const Figure& figure, const CorrelationSample& sample, const Budget& budget) {
    return correlation(even_sample(figure, sample.points, Spread::independent, sample.seed, budget),
                       sample, budget);
}

}  // namespace algae
