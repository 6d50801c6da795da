#include "dimension/generalised.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/error.hpp"
#include "dimension/box_counts.hpp"
#include "dimension/cell_masses.hpp"

namespace algae {

namespace {

constexpr std::size_t most_scales = 20;
constexpr double points_in_cell = 8;
// As for counts of boxes, see fit.cpp: a finite generation gives too little rather than too much.
// For orders below 0 the boxes along the edge of the set, part of them empty, weigh more still.
constexpr double upward = 4.5, missed = 0.05;

/// Sums over the boxes of each order, over all grids; coarsest scale first.
class Sums {
public:
    Sums(std::span<const double> orders, std::size_t scales)
        : orders_(orders.begin(), orders.end()),
          sums_(orders.size(), std::vector<double>(scales)),
          boxes_(scales) {}

    /// The boxes of the finest scale of one grid.
    void add_grid(std::vector<CellMass> cells, int columns, double whole, const Budget& budget) {
        for (std::size_t scale = boxes_.size(); scale-- > 0;) {
            budget.check();
            add_scale(cells, scale, columns, whole);
            if (scale > 0) cells = in_cells_twice_as_wide(cells, columns);
        }
        ++grids_;
    }
    /// The mean number of boxes.
    double boxes(std::size_t scale) const { return boxes_[scale] / static_cast<double>(grids_); }

    Scaling scaling(std::size_t i, const std::vector<double>& sizes, const ScaleRange& range,
                    double detail, int space) const {
        const double order = orders_[i];
        Scaling result;
        result.sizes = sizes;
        std::vector<double> powers;
        for (const double sum : sums_[i]) {
            const double mean = sum / static_cast<double>(grids_);
            result.values.push_back(order == 1 ? -mean : mean);
            powers.push_back(order == 1 ? mean : std::log(mean) / (order - 1));
        }
        Widening widening{order == 0 ? 0.0 : 1.0, order < 0 ? 2 * upward : upward, 0};
        if (detail > 0) widening.beyond = missed * detail / sizes.back();
        fit_scaling(result, powers, range, widening, order < 0 ? HUGE_VAL : space);
        return result;
    }

private:
    void add_scale(const std::vector<CellMass>& cells, std::size_t scale, int columns,
                   double whole) {
        boxes_[scale] += static_cast<double>(cells.size());
        const bool wide =
            std::any_of(orders_.begin(), orders_.end(), [](double q) { return q < 0; });
        const std::vector<double> around =
            wide ? masses_around(cells, columns) : std::vector<double>();
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const double share = cells[k].mass / whole, part = std::log(share);
            const double wide_part = wide ? std::log(around[k] / whole) : 0;
            for (std::size_t i = 0; i < orders_.size(); ++i) {
                const double q = orders_[i];
                if (q < 0 && around[k] > 0)
                    sums_[i][scale] += std::exp(q * wide_part);
                else if (q == 0)
                    sums_[i][scale] += 1;
                else if (q > 0 && share > 0)
                    sums_[i][scale] += q == 1 ? share * part : std::exp(q * part);
            }
        }
    }

    std::vector<double> orders_;
    std::vector<std::vector<double>> sums_;
    std::vector<double> boxes_;
    std::size_t grids_ = 0;
};

void check_choices(std::span<const double> orders, std::size_t offsets) {
    if (orders.empty() || offsets == 0)
        throw Error("expected at least one order and one offset, found " +
                    std::to_string(orders.size()) + " and " + std::to_string(offsets));
    for (const double order : orders)
        if (!std::isfinite(order)) throw Error("expected orders that are numbers");
}

double whole_of(const std::vector<CellMass>& cells) {
    const double whole =
        std::accumulate(cells.begin(), cells.end(), 0.0,
                        [](double sum, const CellMass& cell) { return sum + cell.mass; });
    if (!(whole > 0) || !std::isfinite(whole))
        throw Error("expected something with a length or a weight to measure, found " +
                    std::to_string(whole) + " of it");
    return whole;
}

std::vector<GeneralisedDimension> all_of(const Sums& sums, std::span<const double> orders,
                                         const std::vector<double>& sizes, const ScaleRange& range,
                                         double detail, int space) {
    std::vector<GeneralisedDimension> result;
    for (std::size_t i = 0; i < orders.size(); ++i)
        result.push_back({orders[i], sums.scaling(i, sizes, range, detail, space)});
    return result;
}

}  // namespace

std::vector<GeneralisedDimension> generalised_dimensions(const Figure& figure,
                                                         std::span<const double> orders,
                                                         std::size_t offsets,
                                                         const Budget& budget) {
    check_choices(orders, offsets);
    const double whole = scales_of(figure.box(), 2, 1).coarsest, detail = figure.facts().step;
    ScaleRange range{ScaleRange::details * detail, whole / ScaleRange::parts_of_whole};
    range.scales = "boxes";
    range.follow_rises = true;
    const std::vector<double> sizes =
        halved_sizes(whole, std::min(range.finest, whole), most_scales);
    Sums sums(orders, sizes.size());
    for (const Point offset : even_offsets(offsets)) {
        auto cells =
            drawn_masses(figure, Grid::before(figure.box(), sizes.back(), offset, whole), budget);
        const double length = whole_of(cells);
        sums.add_grid(std::move(cells), 2, length, budget);
    }
    return all_of(sums, orders, sizes, range, detail, 2);
}

std::vector<GeneralisedDimension> generalised_dimensions(const PointSet& points,
                                                         std::span<const double> weights,
                                                         std::span<const double> orders,
                                                         std::size_t offsets,
                                                         const Budget& budget) {
    check_choices(orders, offsets);
    if (!weights.empty() && weights.size() != points.points.size())
        throw Error("expected a weight for each point, found " + std::to_string(weights.size()) +
                    " weights for " + std::to_string(points.points.size()) + " points");
    for (const double weight : weights)
        if (!(weight >= 0))
            throw Error("expected weights of 0 or more, found " + std::to_string(weight));
    const double whole = longest_side(points);
    const std::vector<double> sizes =
        halved_sizes(whole, std::min(ScaleRange::details * points.detail, whole), most_scales);
    Sums sums(orders, sizes.size());
    for (const auto& shares : even_places(offsets)) {
        const auto codes = cell_codes(points, sizes.size(), shares, budget);
        CellMasses masses(budget);
        for (std::size_t i = 0; i < codes.size(); ++i)
            masses.add(codes[i], weights.empty() ? 1 : weights[i]);
        auto cells = masses.take();
        const double weight = whole_of(cells);
        sums.add_grid(std::move(cells), points.columns, weight, budget);
    }
    auto different = points.points;
    std::sort(different.begin(), different.end());
    const auto count =
        static_cast<double>(std::unique(different.begin(), different.end()) - different.begin());
    ScaleRange range{HUGE_VAL, whole / ScaleRange::parts_of_whole};
    for (std::size_t i = 0; i < sizes.size(); ++i)
        if (points.detail > 0 || sums.boxes(i) * points_in_cell <= count) range.finest = sizes[i];
    range.scales = "boxes";
    range.follow_rises = true;
    range.finest_is = points.detail > 0 ? "4 " + points.part + "s"
                                        : "those that hold 8 " + points.part + "s on average";
    range.finer_ones_see = "single " + points.part + "s";
    return all_of(sums, orders, sizes, range, points.detail, points.columns);
}

}  // namespace algae
