#include "dimension/box_counts.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/error.hpp"
#include "dimension/box_counter.hpp"

namespace algae {

double BoxScales::cell(std::size_t scale) const {
    return coarsest / std::pow(ratio, static_cast<double>(scale));
}

BoxScales scales_of(const Box& box, double ratio, std::size_t count) {
    const double side = std::max(box.breadth(), box.height());
    if (box.empty) throw Error("nothing is drawn: expected something to measure");
    if (!std::isfinite(side) || !(side > 0))
        throw Error("expected a figure that is wider or higher than a point, found a size of " +
                    std::to_string(side));
    return {side, ratio, count};
}

double BoxCounts::mean(std::size_t scale) const {
    const auto& all = counts[scale];
    return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}

namespace {

/// How many cells the farthest corner of the box is from the grid's origin.
double reach(const Grid& grid, const Box& box) {
    return std::max(box.high.x - grid.origin.x, box.high.y - grid.origin.y) / grid.cell;
}

}  // namespace

BoxCounts box_counts(const Figure& figure, const BoxScales& scales, std::span<const Point> offsets,
                     const Budget& budget) {
    const Box& box = figure.box();
    if (box.empty) throw Error("nothing is drawn: expected something to measure");
    if (scales.count == 0 || offsets.empty() || !(scales.coarsest > 0) || !(scales.ratio > 1))
        throw Error(
            "expected at least one scale and one offset, a cell wider than 0 and a ratio above 1");
    const bool halves = scales.ratio == 2;
    Budget share = budget;  // of each grid
    share.memory /= offsets.size() * (halves ? 1 : scales.count);
    std::vector<TouchedCells> grids;
    for (std::size_t scale = halves ? scales.count - 1 : 0; scale < scales.count; ++scale)
        for (const Point offset : offsets) {
            const double cell = scales.cell(scale);
            const Grid grid = Grid::before(box, cell, offset, halves ? scales.coarsest : cell);
            grids.emplace_back(grid, reach(grid, box), share);
        }
    BoxCounter counter(std::move(grids));
    figure.draw(counter, 0, budget);

    BoxCounts result;
    result.scales = scales;
    result.detail = figure.facts().step;
    result.parts = counter.segments();
    if (halves) {
        result.counts.resize(scales.count);
        for (TouchedCells& grid : counter.grids()) {
            auto counts = grid.cells().take_counts(static_cast<int>(scales.count) - 1);
            for (std::size_t scale = 0; scale < scales.count; ++scale)
                result.counts[scale].push_back(counts[scales.count - 1 - scale]);
        }
    } else {
        for (std::size_t i = 0; i < counter.grids().size(); ++i) {
            if (i % offsets.size() == 0) result.counts.emplace_back();
            result.counts.back().push_back(counter.grids()[i].cells().take_counts(0).front());
        }
    }
    return result;
}

}  // namespace algae
