#include "dimension/limit_counts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <thread>
#include <unordered_set>

#include "base/error.hpp"
#include "base/parts.hpp"
#include "dimension/descent.hpp"

namespace algae {

namespace {

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
    Counter(const Descent& descent, double scale, double turn, Number place, const Extent& extent,
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
        while (!open.empty()) {
            if (++visits % 65'536 == 0) budget_.check();
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
    /// Whether the same part was looked at in the same place, unless it is small: then it is settled soon.
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
    const Extent whole = extent_of(descent, 0, fine);
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

}  // namespace algae
