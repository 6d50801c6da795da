#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "dimension/detail/cells.hpp"
#include "dimension/detail/measures.hpp"

// Generalised dimensions D_q: how the moments sum p^q of a measure over the boxes of a grid grow
// (Hentschel and Procaccia 1983).
//
// The length that a figure draws in each cell is collected in any order and merged by sorting,
// cells being coded in Morton order; the masses of cells twice as wide follow from the sorted list
// in one pass. For q < 0, boxes that the set barely touches would dominate the sum; there the mass
// of a box and of all boxes around it is taken (Riedi 1995), which is found by a hash table. Where
// the grid lies still changes these sums by large factors, so that a mean of them over the grids is
// that of the worst one: the mean of their logarithms is taken. Points that are a sample of a
// measure say nothing where the boxes that decide, those of least mass, hold few of them: only
// scales are used at which they hold 16 (1 - q) on average.
//
// As with counts of boxes, a finite generation gives too little rather than too much, so the
// interval is widened upward by the same shares as in fit.cpp; for orders below 0 twice as much, as
// boxes along the edge of the set are partly empty.

namespace algae {

namespace {

/// Collects masses of cells in any order. Memory for the different cells, three times over at most.
class CellMasses {
public:
    explicit CellMasses(const Budget& budget) : budget_(budget) {}

    void add(std::uint64_t code, double mass) {
        if (!masses_.empty() && masses_.back().code == code) {
            masses_.back().mass += mass;
            return;
        }
        if (masses_.size() >= limit_) merge();
        masses_.push_back({code, mass});
    }
    /// Every cell once, in the order of codes; empties the collection. Throws BoundReached.
    std::vector<CellMass> take() {
        merge();
        return std::exchange(masses_, {});
    }

private:
    void merge();

    Budget budget_;
    std::vector<CellMass> masses_;
    std::size_t limit_ = 1 << 16;
};

constexpr double most_cells = 2147483648.0;  // side by side: 31 bits a coordinate

/// The bits of one coordinate of a code.
std::uint64_t bits_of(int coordinate, int columns) {
    std::uint64_t mask = 0;
    for (int bit = coordinate; bit < 64; bit += columns) mask |= std::uint64_t{1} << bit;
    return mask;
}

/// Steps to the neighbours on one axis; one beyond 0 has a code that no cell has.
std::uint64_t next(std::uint64_t code, std::uint64_t axis) {
    return (code & ~axis) | (((code | ~axis) + 1) & axis);
}

std::uint64_t previous(std::uint64_t code, std::uint64_t axis) {
    return (code & ~axis) | (((code & axis) - 1) & axis);
}

void CellMasses::merge() {
    budget_.check();
    std::sort(masses_.begin(), masses_.end(),
              [](const CellMass& a, const CellMass& b) { return a.code < b.code; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < masses_.size(); ++i)
        if (kept > 0 && masses_[kept - 1].code == masses_[i].code)
            masses_[kept - 1].mass += masses_[i].mass;
        else
            masses_[kept++] = masses_[i];
    masses_.resize(kept);
    limit_ = std::max(limit_, 2 * kept);
    budget_.check_memory(3 * kept * sizeof(CellMass), "the lengths in the cells of a grid");
}

}  // namespace

std::vector<CellMass> drawn_masses(const Figure& figure, const Grid& grid, const Budget& budget) {
    const Box& box = figure.box();
    const double most = (most_cells - 1) * grid.cell;
    if (!(box.low.x >= grid.origin.x && box.low.y >= grid.origin.y &&
          box.high.x - grid.origin.x < most && box.high.y - grid.origin.y < most))
        throw Error("expected a figure within 2^31 cells right of and above the grid's origin");
    CellMasses masses(budget);
    DrawnSegments canvas([&](Point start, Point end, bool) {
        const GridPoint from = grid.at(start), to = grid.at(end);
        const double length = distance(start, end);
        const bool right = to.x > from.x, up = to.y > from.y;
        Morton cell(static_cast<std::uint64_t>(from.column()),
                    static_cast<std::uint64_t>(from.row()));
        double done = 0;
        walk_cells(from, to, [&](const Crossing& crossing) {
            const double share = crossing.share();
            masses.add(cell.code, (share - done) * length);
            done = share;
            if (crossing.sideways) right ? cell.right() : cell.left();
            if (crossing.upright) up ? cell.up() : cell.down();
        });
        masses.add(cell.code, (1 - done) * length);
    });
    figure.draw(canvas, 0, budget);
    return masses.take();
}

namespace {

/// The same measure in cells twice as wide, where codes have the bits of so many coordinates in
/// turns. The list must be in the order of codes. O(cells).
std::vector<CellMass> in_cells_twice_as_wide(const std::vector<CellMass>& cells, int columns) {
    std::vector<CellMass> wider;
    for (const CellMass& cell : cells) {
        const std::uint64_t code = cell.code >> columns;
        if (!wider.empty() && wider.back().code == code)
            wider.back().mass += cell.mass;
        else
            wider.push_back({code, cell.mass});
    }
    return wider;
}

/// For each cell the mass of it and of all cells around it: of a box three times as wide. O(cells).
std::vector<double> masses_around(const std::vector<CellMass>& cells, int columns) {
    std::unordered_map<std::uint64_t, double> mass_of;
    mass_of.reserve(cells.size());
    for (const CellMass& cell : cells) mass_of.emplace(cell.code, cell.mass);
    std::vector<double> around;
    around.reserve(cells.size());
    std::vector<std::uint64_t> codes;
    for (const CellMass& cell : cells) {
        codes.assign(1, cell.code);
        for (int i = 0; i < columns; ++i) {
            const std::uint64_t axis = bits_of(i, columns);
            for (std::size_t k = codes.size(); k-- > 0;) {
                codes.push_back(next(codes[k], axis));
                codes.push_back(previous(codes[k], axis));
            }
        }
        double sum = 0;
        for (const std::uint64_t code : codes)
            if (const auto found = mass_of.find(code); found != mass_of.end()) sum += found->second;
        around.push_back(sum);
    }
    return around;
}

/// OrderSums over the boxes of each order, over all grids; coarsest scale first.
class OrderSums {
public:
    OrderSums(std::span<const double> orders, std::size_t scales)
        : orders_(orders.begin(), orders.end()),
          sums_(orders.size(), std::vector<double>(scales)),
          deciding_(orders.size(), std::vector<double>(scales, HUGE_VAL)),
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

    /// `counted`: the measure counts points, which are too few where the boxes that decide hold few.
    Scaling scaling(std::size_t i, const std::vector<double>& sizes, ScaleRange range,
                    double detail, int space, bool counted) const {
        const double order = orders_[i];
        Scaling result;
        result.sizes = sizes;
        std::vector<double> powers;
        for (const double sum : sums_[i]) {
            const double mean = sum / static_cast<double>(grids_);
            result.values.push_back(order == 1 ? -mean : order < 0 ? std::exp(mean) : mean);
            powers.push_back(order == 1  ? mean
                             : order < 0 ? mean / (order - 1)
                                         : std::log(mean) / (order - 1));
        }
        if (order < 0 && counted) {
            const double least = points_in_box * (1 - order);
            double finest = HUGE_VAL;
            for (std::size_t k = 0; k < sizes.size() && deciding_[i][k] >= least; ++k)
                finest = sizes[k];
            if (finest > range.finest) {
                range.finest = finest;
                range.finest_is =
                    fmt::format("those where boxes that decide hold {:g} points", least);
            }
        }
        Widening widening{order == 0 ? 0.0 : 1.0, (order < 0 ? 2 : 1) * Widening::upward, 0};
        if (detail > 0) widening.beyond = Widening::missed * detail / sizes.back();
        if (order < 0 && counted) widening.beyond += by_sample;
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
        std::vector<double> sums(orders_.size()), firsts(orders_.size());
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const double share = cells[k].mass / whole, part = std::log(share);
            const double wide_part = wide ? std::log(around[k] / whole) : 0;
            for (std::size_t i = 0; i < orders_.size(); ++i) {
                const double q = orders_[i];
                if (q < 0 && around[k] > 0) {
                    const double power = std::exp(q * wide_part);
                    sums[i] += power;
                    firsts[i] += power * around[k];
                } else if (q == 0) {
                    sums[i] += 1;
                } else if (q > 0 && share > 0) {
                    sums[i] += q == 1 ? share * part : std::exp(q * part);
                }
            }
        }
        for (std::size_t i = 0; i < orders_.size(); ++i) {
            sums_[i][scale] += orders_[i] < 0 ? std::log(sums[i]) : sums[i];
            if (orders_[i] < 0)
                deciding_[i][scale] = std::min(deciding_[i][scale], firsts[i] / sums[i]);
        }
    }

    static constexpr double points_in_box = 16;  // for each order below 1
    static constexpr double by_sample = 0.1;     // what a sample may lack in its rarest boxes

    std::vector<double> orders_;
    std::vector<std::vector<double>> sums_;      // for orders below 0 of their logarithms
    std::vector<std::vector<double>> deciding_;  // for orders below 0 the mass that weighs most
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

std::vector<GeneralisedDimension> all_of(const OrderSums& sums, std::span<const double> orders,
                                         const std::vector<double>& sizes, const ScaleRange& range,
                                         double detail, int space, bool counted = false) {
    std::vector<GeneralisedDimension> result;
    for (std::size_t i = 0; i < orders.size(); ++i)
        result.push_back({orders[i], sums.scaling(i, sizes, range, detail, space, counted)});
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
    const std::vector<double> sizes = halved_sizes(whole, std::min(range.finest, whole));
    OrderSums sums(orders, sizes.size());
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
        halved_sizes(whole, std::min(ScaleRange::details * points.detail, whole));
    OrderSums sums(orders, sizes.size());
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
        if (points.detail > 0 || sums.boxes(i) * ScaleRange::points_in_cell <= count)
            range.finest = sizes[i];
    range.scales = "boxes";
    range.follow_rises = true;
    range.finest_is = points.detail > 0 ? "4 " + points.part + "s"
                                        : "those that hold 8 " + points.part + "s on average";
    range.finer_ones_see = "single " + points.part + "s";
    return all_of(sums, orders, sizes, range, points.detail, points.columns,
                  weights.empty() && points.detail == 0);
}

}  // namespace algae
