#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <thread>
#include <unordered_set>

#include "dimension/detail/measures.hpp"
#include "dimension/detail/recurrent_set.hpp"
#include "watch/watch.hpp"

// Counting boxes of the limit itself, not of one of its generations.
//
// The recurrent set K is walked down, depth first, from the whole to ever smaller parts. A part
// whose disc is small touches the cell of a point of it that is known (`Descent::points`). A part
// all of whose cells are known to be touched is skipped. So the work is that of the cells touched,
// not that of the segments of the generation that would be as fine. Where parts coincide, each
// place is visited once (`Counter::was_here`).
//
// Scale j counts the cells that mu^(j levels) K touches, so that all scales see the same set in the
// same direction and ratios of counts do not wobble. Grids are moved and turned at random; they are
// counted in parallel, and the numbers do not depend on the number of threads.
//
// The fit uses what is known exactly. If pairs of parts that meet multiply by rho (neighbours.cpp),
// counts are close to A r^(j D) + B rho^j, and n_j - rho n_(j-1) is free of the second term: its
// slope is taken over the finest scales, with the baseline that makes the interval shortest.
// Components that multiply more slowly add terms of their own rates, and where a component of the
// largest rate leads to another one, counts grow as j times that power: all of these rates are known
// and taken out in the same way. Where
// rho is unknown, or so near the rate of the parts that the difference is lost (Levy's curve),
// local slopes are extrapolated, and the interval is wide. Standard errors are those of leaving out
// one grid at a time; the interval is three of them and the change from the estimate one scale
// coarser.

namespace algae {

namespace {

/// A complex number whose products are four multiplications: no care is taken of infinite ones.
struct Number {
    double x = 0, y = 0;

    Number() = default;
    Number(double real, double imaginary) : x(real), y(imaginary) {}
    Number(std::complex<double> number) : x(number.real()), y(number.imag()) {}
    friend Number operator+(Number a, Number b) { return {a.x + b.x, a.y + b.y}; }
    friend Number operator*(Number a, Number b) {
        return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
    }
    double real() const { return x; }
    double imag() const { return y; }
};

inline Number polar(double size, double angle) { return std::polar(size, angle); }

/// The parts of a set as numbers, ready to be walked down.
struct Descent {
    struct Part {
        std::size_t piece;
        std::size_t heading;
        Number offset;  // in units of the whole
    };
    std::vector<std::vector<Part>> parts;
    struct Disc {
        Number centre;
        double radius;
    };
    std::vector<Disc> discs;
    std::vector<Number> points;  // one of each piece
    std::vector<Part> axiom;
    std::vector<Number> turns;
    Number shrink;   // 1/mu
    double smaller;  // its size

    explicit Descent(const RecurrentSet& set);
};

/// A piece somewhere: it covers start + unit * K_piece, where |unit| = size.
struct Placed {
    std::size_t piece;
    Number start, unit;
    double size;
};

/// A box around a set.
struct Sides {
    double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
};

Descent::Descent(const RecurrentSet& set)
    : shrink(1.0 / set.displacement().factor()), smaller(1 / set.displacement().ratio()) {
    const auto headings = static_cast<std::size_t>(set.order());
    for (std::size_t h = 0; h < headings; ++h)
        turns.push_back(polar(
            1, 2 * std::numbers::pi * static_cast<double>(h) / static_cast<double>(headings)));
    const auto part_of = [&](const RecurrentSet::Part& part, Number unit) {
        const auto heading = static_cast<std::size_t>(normal_heading(part.heading, set.order()));
        return Part{part.piece, heading, Number(set.displacement().value(part.offset)) * unit};
    };
    for (std::size_t p = 0; p < set.size(); ++p) {
        auto& own = parts.emplace_back();
        for (const RecurrentSet::Part& part : set.parts(p)) own.push_back(part_of(part, shrink));
        discs.push_back({set.disc(p).centre, set.disc(p).radius});
    }
    for (const RecurrentSet::Part& part : set.axiom()) axiom.push_back(part_of(part, {1, 0}));
    // The limit of the first parts.
    points.resize(parts.size());
    const int deep = static_cast<int>(std::ceil(40 / std::log(set.displacement().ratio()))) + 1;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        Number start, unit{1, 0};
        std::size_t piece = p;
        for (int level = 0; level < deep && !parts[piece].empty(); ++level) {
            const Part& first = parts[piece].front();
            start = start + unit * first.offset;
            unit = unit * shrink * turns[first.heading];
            piece = first.piece;
        }
        points[p] = start;
    }
}

/// A box around the set turned by an angle, from the discs of parts so many levels below.
Sides extent_of(const Descent& descent, double turn, int levels) {
    Sides extent;
    const auto visit = [&](const auto& self, const Placed& at, int left) -> void {
        const auto& disc = descent.discs[at.piece];
        const Number centre = at.start + at.unit * disc.centre;
        const double radius = at.size * disc.radius;
        if (left == 0 ||
            (centre.real() - radius > extent.left && centre.real() + radius < extent.right &&
             centre.imag() - radius > extent.low && centre.imag() + radius < extent.high)) {
            if (left > 0) return;
            extent.left = std::min(extent.left, centre.real() - radius);
            extent.right = std::max(extent.right, centre.real() + radius);
            extent.low = std::min(extent.low, centre.imag() - radius);
            extent.high = std::max(extent.high, centre.imag() + radius);
            return;
        }
        for (const auto& part : descent.parts[at.piece])
            self(
                self,
                {part.piece, at.start + at.unit * part.offset,
                 at.unit * descent.shrink * descent.turns[part.heading], at.size * descent.smaller},
                left - 1);
    };
    const Number rotation = polar(1, turn);
    for (const auto& part : descent.axiom)
        visit(visit,
              {part.piece, rotation * part.offset, rotation * descent.turns[part.heading], 1},
              levels);
    return extent;
}

constexpr double smallest_part = 1.0 / 128;  // of a cell
constexpr double most_across = 0x1p40;
constexpr std::int64_t most_dense = std::int64_t{1} << 28;  // cells
constexpr double least_across = 8;                          // cells; 2 where scales are far apart
constexpr std::size_t least_scales = 4;

/// Cells that are known to be touched: bits where they are not too many, otherwise a set.
class Cells {
public:
    void resize(std::int64_t across, std::int64_t up) {
        across_ = across;
        if (across <= most_dense / up) dense_.assign(static_cast<std::size_t>(across * up), false);
    }
    bool has(std::int64_t x, std::int64_t y) const {
        const std::int64_t cell = y * across_ + x;
        return dense_.empty() ? sparse_.contains(cell) : dense_[static_cast<std::size_t>(cell)];
    }
    void add(std::int64_t x, std::int64_t y) {
        const std::int64_t cell = y * across_ + x;
        if (dense_.empty()) {
            if (sparse_.insert(cell).second) ++count_;
        } else if (!dense_[static_cast<std::size_t>(cell)]) {
            dense_[static_cast<std::size_t>(cell)] = true;
            ++count_;
        }
    }
    std::uint64_t count() const { return count_; }

private:
    std::int64_t across_ = 0;
    std::vector<bool> dense_;
    std::unordered_set<std::int64_t> sparse_;
    std::uint64_t count_ = 0;
};

/// The cells of one grid that the set touches.
class Counter {
public:
    Counter(const Descent& descent, double scale, double turn, Number place, const Sides& extent,
            bool coinciding, const Budget& budget)
        : descent_(descent),
          budget_(budget),
          scale_(scale),
          unit_(polar(scale, turn)),
          place_(place),
          coinciding_(coinciding) {
        // Cells are numbered from the lower left corner, so that coordinates are not negative.
        place_ = {place.x + std::ceil(1 - scale * extent.left - place.x),
                  place.y + std::ceil(1 - scale * extent.low - place.y)};
        across_ = static_cast<std::int64_t>(place_.x + scale * extent.right) + 2;
        up_ = static_cast<std::int64_t>(place_.y + scale * extent.high) + 2;
        touched_.resize(across_, up_);
    }

    std::uint64_t count() {
        std::vector<Placed> open;
        for (const auto& part : descent_.axiom)
            open.push_back({part.piece, place_ + unit_ * part.offset,
                            unit_ * descent_.turns[part.heading], scale_});
        std::uint64_t visits = 0;
        WorkCount parts_seen("parts of the limit");
        while (!open.empty()) {
            if (++visits % 65'536 == 0) budget_.check();
            parts_seen.at(visits);
            const Placed at = open.back();
            open.pop_back();
            if (is_settled(at) || (coinciding_ && was_here(at))) continue;
            const Number smaller = at.unit * descent_.shrink;
            const double size = at.size * descent_.smaller;
            const auto& parts = descent_.parts[at.piece];
            for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
                open.push_back({part->piece, at.start + at.unit * part->offset,
                                smaller * descent_.turns[part->heading], size});
                const Placed& child = open.back();
                // All points at once: then a part that goes on into the next cell finds it touched.
                if (size * descent_.discs[child.piece].radius > 2) continue;
                const Number point = child.start + child.unit * descent_.points[child.piece];
                touched_.add(column(point.real()), row(point.imag()));
            }
        }
        return touched_.count();
    }

private:
    /// Whether the same part was looked at in the same place, unless it is small: then it is
    /// settled soon.
    bool was_here(const Placed& at) {
        constexpr double grain = 1 << 20;  // of a cell
        if (at.size * descent_.discs[at.piece].radius < 0.5) return false;
        std::uint64_t key = at.piece;
        for (const double part : {at.start.x, at.start.y, at.unit.x, at.unit.y}) {
            key = (key ^ static_cast<std::uint64_t>(std::llround(part * grain))) *
                  0xBF58476D1CE4E5B9u;
            key ^= key >> 29;
        }
        return !seen_.insert(key).second;
    }

    /// Whether nothing more is to be learnt from a part.
    bool is_settled(const Placed& at) {
        const auto& disc = descent_.discs[at.piece];
        const Number centre = at.start + at.unit * disc.centre;
        const double radius = at.size * disc.radius;
        if (radius > 2) return false;
        const std::int64_t x0 = column(centre.real() - radius), x1 = column(centre.real() + radius);
        const std::int64_t y0 = row(centre.imag() - radius), y1 = row(centre.imag() + radius);
        if (radius < smallest_part) return true;
        for (std::int64_t y = y0; y <= y1; ++y)
            for (std::int64_t x = x0; x <= x1; ++x)
                if (!touched_.has(x, y)) return false;
        return true;
    }
    std::int64_t column(double x) const {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(x), 0, across_ - 1);
    }
    std::int64_t row(double y) const {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(y), 0, up_ - 1);
    }
    const Descent& descent_;
    const Budget& budget_;
    double scale_;
    Number unit_, place_;
    std::int64_t across_ = 0, up_ = 0;
    bool coinciding_;
    Cells touched_;
    std::unordered_set<std::uint64_t> seen_;
};

}  // namespace

LimitCounts limit_counts(const RecurrentSet& set, const LimitCounting& options,
                         const Budget& budget) {
    const Descent descent(set);
    LimitCounts out;
    BoxCounts& boxes = out.boxes;
    const double ratio = set.displacement().ratio();
    while (std::pow(ratio, static_cast<double>(out.levels)) < 1.9) ++out.levels;
    boxes.scales.ratio = std::pow(ratio, static_cast<double>(out.levels));
    const double turn = std::arg(set.displacement().factor()) * static_cast<double>(out.levels);
    const int fine = static_cast<int>(std::ceil(std::log(40.0) / std::log(ratio)));
    const Sides whole = extent_of(descent, 0, fine);
    const double size = std::max(whole.right - whole.left, whole.high - whole.low);
    const double diameter = std::hypot(whole.right - whole.left, whole.high - whole.low);
    if (!(size > 0)) throw Error("the limit of the curve is a point");

    std::mt19937_64 random(options.seed);
    const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    struct TurnedGrid {
        Number offset;
        double angle;
    };
    std::vector<TurnedGrid> places;
    for (std::size_t i = 0; i < options.places; ++i) {
        const double x = share(), y = share();
        places.push_back({{x, y}, 2 * std::numbers::pi * share()});
    }
    const double across_first = boxes.scales.ratio > 3.5 ? 2 : least_across;
    const double first = across_first / size;
    boxes.scales.coarsest = 1 / across_first;
    boxes.whole = 1;
    for (std::size_t j = 0;; ++j) {
        const double scale = first * std::pow(boxes.scales.ratio, static_cast<double>(j));
        const double angle = turn * static_cast<double>(j);
        const double across = scale * diameter;
        if (across > most_across) break;
        budget.check_memory(static_cast<std::uint64_t>(std::min(across * across, 0x1p28) / 8) *
                                std::thread::hardware_concurrency(),
                            "a grid of cells");
        std::vector<std::uint64_t> counts(places.size());
        const PartWorker count_at = [&](std::size_t i) {
            const double own = angle + places[i].angle;
            counts[i] = Counter(descent, scale, own, places[i].offset,
                                extent_of(descent, own, fine), options.coinciding, budget)
                            .count();
        };
        each_part(
            places.size(), 0, budget, [&] { return count_at; }, 1);
        boxes.counts.push_back(std::move(counts));
        const double now = boxes.mean(j);
        if (j + 1 >= least_scales &&
            now * now / boxes.mean(j - 1) > static_cast<double>(options.most_cells))
            break;
    }
    boxes.scales.count = boxes.counts.size();
    return out;
}

namespace {

constexpr std::size_t longest_baseline = 3;  // in scales
constexpr double lost = 0.95;                // of the cells that the boundary term may take
constexpr double widest = 0.5;               // half an interval that still says something
constexpr std::size_t most_terms = 4;        // that are taken out of counts

/// The counts of places of a grid, with one of them left out or all, and terms of known rates for
/// each scale taken out.
class Means {
public:
    Means(const BoxCounts& counts, const std::vector<double>& rates) : counts_(counts) {
        for (const double rate : rates) {
            weights_.push_back(0);
            for (std::size_t k = weights_.size() - 1; k > 0; --k)
                weights_[k] -= rate * weights_[k - 1];
        }
    }

    static constexpr std::size_t nobody = ~std::size_t{0};

    /// The mean of n_j - rho n_(j-1) for one rate rho; the same again for each further one. There
    /// are so many scales below j.
    double combined(std::size_t scale, std::size_t without) const {
        double sum = 0;
        for (std::size_t k = 0; k < weights_.size(); ++k)
            sum += weights_[k] * mean(scale - k, without);
        return sum;
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
    std::vector<double> weights_{1};  // of the scale, and of those above it
};

/// What is measured above the bound stands at it.
Estimate interval(double value, double half, double bound) {
    const double within = std::min(value, bound);
    return {within, std::max(within - half, 0.0), std::min(value + half, bound)};
}

/// With the terms of these rates for each scale taken out. Nothing where there are too few scales,
/// or noise is all that they leave.
bool fit_known_terms(const BoxCounts& counts, const std::vector<double>& rates, double bound,
                     BoxFit& fit) {
    const Means means(counts, rates);
    const std::size_t last = counts.counts.size() - 1;
    double shortest = INFINITY;
    for (std::size_t baseline = 1;
         baseline <= longest_baseline && baseline + 1 + rates.size() <= last; ++baseline) {
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
    if (!(shortest < widest)) {
        fit.estimate.reset();
        return false;
    }
    fit.last = last;
    // The terms at the finest scale; where the rate of the whole is taken out too, the plot shows
    // the line through the last count.
    const double largest = *std::max_element(rates.begin(), rates.end());
    double share = 1;
    for (const double rate : rates) share *= 1 - rate * std::pow(counts.scales.ratio, -fit.slope);
    const bool can_be_parted = std::abs(share) > 0.01;
    const double whole =
        can_be_parted ? means.combined(last, Means::nobody) / share : counts.mean(last);
    fit.intercept = std::log(whole) + fit.slope * std::log(counts.scales.cell(last));
    fit.rate = can_be_parted ? largest : 1;
    fit.boundary = (counts.mean(last) - whole) / std::pow(fit.rate, static_cast<double>(last));
    return true;
}

/// By extrapolation of the local slopes.
void fit_slopes(const BoxCounts& counts, bool is_lost, double bound, BoxFit& fit) {
    const Means means(counts, {});
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

double greatest_dimension(const ExactDimension& exact) {
    if (exact.status != ExactDimension::Status::upper_bound) return 2;
    return std::min(exact.value->enclosure(64).midpoint(), 2.0);
}

BoxFit fit_limit(const LimitCounts& limit, const std::optional<Rate>& meeting, double bound,
                 const LowerTerms& lower) {
    const BoxCounts& counts = limit.boxes;
    BoxFit fit;
    fit.slopes = local_slopes(counts);
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
    if (!meeting || is_lost) {
        fit_slopes(counts, is_lost, bound, fit);
        return fit;
    }
    // Largest first: what is left out where scales are few matters least.
    std::vector<double> rates{rho};
    std::string names;
    const auto take = [&](const Rate& rate) {
        if (rates.size() >= most_terms) return;
        const double own =
            std::pow(rate.enclosure(64).midpoint(), static_cast<double>(limit.levels));
        rates.push_back(own);
        names += fmt::format("{}{:.4g}", names.empty() ? "" : ", ", own);
    };
    for (std::size_t k = 1; k < lower.chain; ++k) take(*lower.largest);
    for (const Rate& rate : lower.rates)
        if (!(rate == *meeting)) take(rate);
    const std::string known = fmt::format(
        "counted on the limit itself; slope over the finest scales of n_j - rho n_(j-1), "
        "with rho = {:.4g} for each scale from the pairs of parts that meet",
        rho);
    if (!names.empty() && fit_known_terms(counts, rates, bound, fit)) {
        fit.because = known + ", and in the same way " + names + " from " +
                      (lower.chain > 1 ? "components that follow on each other"
                                       : "components that multiply more slowly");
        return fit;
    }
    if (fit_known_terms(counts, {rho}, bound, fit))
        fit.because = known;
    else
        fit_slopes(counts, is_lost, bound, fit);
    return fit;
}

LowerTerms lower_terms(const ExactDimension& exact) {
    LowerTerms found;
    if (!exact.limit || !exact.value || !exact.value->log_ratio() || !exact.similarity ||
        exact.status != ExactDimension::Status::exact ||
        exact.value->text() != exact.similarity->text())
        return found;
    const RecurrentSet& set = *exact.limit;
    const Rate& largest = exact.value->log_ratio()->rate();
    found.largest = largest;
    // What occurs in a component's successors stands before it: chains are counted upward.
    const auto& list = set.components().list;
    std::vector<std::size_t> chains(list.size(), 0);
    std::vector<Rate> rates;
    for (std::size_t k = 0; k < list.size(); ++k) {
        for (const std::size_t below : list[k].below)
            chains[k] = std::max(chains[k], chains[below]);
        if (!list[k].rate || *list[k].rate == Rate(1) || is_point(set, list[k])) continue;
        if (*list[k].rate == largest) ++chains[k];
        if (!set.is_reached(list[k].letters.front())) continue;
        found.chain = std::max(found.chain, chains[k]);
        if (*list[k].rate < largest &&
            std::find(rates.begin(), rates.end(), *list[k].rate) == rates.end())
            rates.push_back(*list[k].rate);
    }
    std::sort(rates.begin(), rates.end(), [](const Rate& a, const Rate& b) { return a > b; });
    found.rates = std::move(rates);
    return found;
}

LimitMeasure measure_limit(const ExactDimension& exact, LimitCounting counting,
                           const Budget& budget) {
    const bool coincide = exact.value->text() != exact.similarity->text();
    counting.coinciding = coincide || exact.status != ExactDimension::Status::exact;
    if (coincide) counting.most_cells /= 2;
    LimitCounts counts = limit_counts(*exact.limit, counting, budget);
    BoxFit fit = fit_limit(counts, exact.meeting, greatest_dimension(exact), lower_terms(exact));
    return {std::move(counts), std::move(fit)};
}

}  // namespace algae
