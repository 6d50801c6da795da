#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <numbers>
#include <set>

#include "dimension/detail/recurrent_set.hpp"
#include "model/model.hpp"

// Certified bounds of the dimension of a recurrent set, where it is not known whether parts meet in
// finitely many ways.
//
// From above: the number of different parts of late levels. A part is told apart by the others near
// it that coincide with parts of it within so many levels; what coincides later counts twice. A part
// that several of them share belongs to the first in a fixed order of places (that of coordinates,
// which shifts do not change), so none is lost, whatever is not looked at. There are finitely many
// kinds; the spectral radius of their matrix bounds the rate of different parts (compare Ngai and
// Wang 2001, who look at all of them). Coverings by parts of one level then bound the box dimension.
//
// From below: pairs of parts. Give every word of n parts the same share of the mass, within constants
// rate^-n. If at most C pairs^n of the rate^2n pairs of words are near each other, the energy of the
// mass is finite for every s < (2 log rate - log pairs) / log |mu|, so the Hausdorff dimension is at
// least that (Frostman; Pollicott and Vytnova bound the correlation dimension of Bernoulli
// convolutions in this way). A pair of the same part twice multiplies by the rate alone. For the
// others, the place of one seen from the other lies in a disc, which is cut into square cells: if W is
// positive and, for each cell, the sum over the pairs of parts of the largest W of a cell that they
// may come to is at most pairs * W, then pairs^n bounds their number (Collatz and Wielandt). Smaller
// cells make it smaller.
//
// Floating point with margins: sums have few positive terms, and every comparison is widened by far
// more than rounding. Logarithms at the end are in ball arithmetic.

namespace algae {

namespace {

using Complex = std::complex<double>;

constexpr double rounding = 1e-9;
constexpr std::size_t most_pairs = 40'000, most_kinds = 30'000;

/// The spectral radius of a matrix with rows of columns, each entry 1; from above.
double radius_above(const std::vector<std::vector<std::size_t>>& rows, const Budget& budget) {
    constexpr int most_rounds = 2000;
    std::vector<double> weights(rows.size(), 1), next(rows.size());
    double best = INFINITY;
    for (int round = 0; round < most_rounds; ++round) {
        if (round % 16 == 0) budget.check();
        double largest = 0, radius = 0;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            double sum = 0;
            for (const std::size_t column : rows[k]) sum += weights[column];
            radius = std::max(radius, sum / weights[k]);
            next[k] = sum + weights[k];  // of the matrix and 1: periods do not matter
            largest = std::max(largest, next[k]);
        }
        const bool settled = best - radius < 1e-10 * best;
        best = std::min(best, radius);
        if (settled && round > 200) break;
        for (std::size_t k = 0; k < rows.size(); ++k)
            weights[k] = std::max(next[k] / largest, 1e-200);
    }
    return best * (1 + rounding);
}

// From above.

/// The pairs that a search of bounded length finds, with the levels until they coincide.
class Coincidences {
public:
    Coincidences(const RecurrentSet& set, std::size_t component, const Budget& budget) : set_(set) {
        for (const std::size_t piece : set.components().list[component].letters) {
            const Placement here{piece, 0, set.displacement().zero()};
            add_pairs(here, here, starts_, true);
        }
        for (std::size_t k = 0; k < pairs_.size() && pairs_.size() < most_pairs; ++k) {
            if (k % 256 == 0) budget.check();
            const auto [piece, other] = pairs_[k];
            std::vector<std::size_t> next;
            if (!is_one(pairs_[k]))
                add_pairs({piece, 0, set.displacement().zero()}, other, next, false);
            for (const std::size_t to : next) before_[to].push_back(k);
        }
        find_levels();
    }

    bool found() const { return found_; }
    /// In at most so many levels some parts of the two coincide.
    bool within(std::size_t piece, const Placement& other, int levels) const {
        const auto place = numbers_.find({piece, other});
        return place != numbers_.end() && levels_[place->second] <= levels;
    }

private:
    using Pair = std::pair<std::size_t, Placement>;

    bool is_one(const Pair& pair) const {
        return pair.first == pair.second.piece && pair.second.heading == 0 &&
               pair.second.offset == set_.displacement().zero();
    }

    void add_pairs(const Placement& first, const Placement& second, std::vector<std::size_t>& into,
                   bool different) {
        const auto own = parts_within(set_, first.piece), others = parts_within(set_, second.piece);
        for (std::size_t i = 0; i < own.size(); ++i)
            for (std::size_t k = 0; k < others.size(); ++k) {
                if (different && i == k) continue;
                const Placement at = placed(set_, first, own[i]);
                Placement seen = seen_from(set_, at, placed(set_, second, others[k]));
                if (!near(at.piece, seen)) continue;
                const auto [place, is_new] =
                    numbers_.try_emplace({at.piece, std::move(seen)}, pairs_.size());
                if (is_new) {
                    pairs_.push_back(place->first);
                    before_.emplace_back();
                }
                into.push_back(place->second);
            }
    }

    bool near(std::size_t piece, const Placement& other) const {
        const double angle = 2 * std::numbers::pi * static_cast<double>(other.heading) /
                             static_cast<double>(set_.order());
        const auto &first = set_.disc(piece), &second = set_.disc(other.piece);
        const Complex centre =
            set_.displacement().value(other.offset) + std::polar(1.0, angle) * second.centre;
        return std::abs(centre - first.centre) <= first.radius + second.radius + 1e-6;
    }

    void find_levels() {
        constexpr int never = 1'000'000;
        levels_.assign(pairs_.size(), never);
        std::deque<std::size_t> open;
        for (std::size_t k = 0; k < pairs_.size(); ++k)
            if (is_one(pairs_[k])) {
                levels_[k] = 0;
                open.push_back(k);
                found_ = true;
            }
        for (; !open.empty(); open.pop_front())
            for (const std::size_t whole : before_[open.front()])
                if (levels_[whole] == never) {
                    levels_[whole] = levels_[open.front()] + 1;
                    open.push_back(whole);
                }
    }

    const RecurrentSet& set_;
    std::vector<Pair> pairs_;
    std::vector<std::size_t> starts_;
    std::vector<std::vector<std::size_t>> before_;
    std::map<Pair, std::size_t> numbers_;
    std::vector<int> levels_;
    bool found_ = false;
};

/// The kinds of parts, by those near them that coincide with parts of them within some levels.
class Kinds {
public:
    Kinds(const RecurrentSet& set, const Coincidences& coincidences, int levels)
        : set_(set), coincidences_(coincidences), levels_(levels) {}

    /// An upper bound of the rate of different parts; none if there are too many kinds.
    std::optional<double> rate(std::size_t piece, const Budget& budget) {
        number({{piece, 0, set_.displacement().zero()}, {}});
        std::vector<std::vector<std::size_t>> rows;
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            budget.check();
            if (kinds_.size() > most_kinds) return std::nullopt;
            rows.push_back(parts_of(*kinds_[k]));
        }
        return radius_above(rows, budget);
    }

private:
    /// A part with its heading, and others around it; all turned as in the whole.
    struct Kind {
        Placement self;  // at 0
        std::vector<Placement> others;
        bool operator<(const Kind& other) const {
            return self < other.self || (!(other.self < self) && others < other.others);
        }
    };

    std::size_t number(Kind kind) {
        const auto [place, is_new] = numbers_.try_emplace(std::move(kind), kinds_.size());
        if (is_new) kinds_.push_back(&place->first);
        return place->second;
    }

    /// A fixed order of places, which shifts do not change.
    static bool is_before(const Placement& a, const Placement& b) {
        if (a.offset != b.offset) return a.offset < b.offset;
        if (a.heading != b.heading) return a.heading < b.heading;
        return a.piece < b.piece;
    }

    std::vector<std::size_t> parts_of(const Kind& whole) {
        std::map<Placement, bool> parts;  // whether the whole keeps it
        for (const RecurrentSet::Part& part : parts_within(set_, whole.self.piece))
            parts[placed(set_, whole.self, part)] = true;
        for (const Placement& other : whole.others) {
            const bool first = is_before(other, whole.self);
            for (const RecurrentSet::Part& part : parts_within(set_, other.piece)) {
                const auto [at, is_new] = parts.try_emplace(placed(set_, other, part), false);
                if (first) at->second = false;
            }
        }
        std::vector<std::size_t> found;
        for (const auto& [part, kept] : parts) {
            if (!kept) continue;
            Kind kind{{part.piece, part.heading, set_.displacement().zero()}, {}};
            for (const auto& [other, is_own] : parts) {
                if (other == part) continue;
                if (!coincidences_.within(part.piece, seen_from(set_, part, other), levels_) &&
                    !coincidences_.within(other.piece, seen_from(set_, other, part), levels_))
                    continue;
                Placement moved = other;
                set_.displacement().subtract(moved.offset, part.offset);
                kind.others.push_back(std::move(moved));
            }
            std::sort(kind.others.begin(), kind.others.end());
            found.push_back(number(std::move(kind)));
        }
        return found;
    }

    const RecurrentSet& set_;
    const Coincidences& coincidences_;
    int levels_;
    std::map<Kind, std::size_t> numbers_;
    std::vector<const Kind*> kinds_;
};

// From below.

/// The different parts of some level of each piece of a component.
struct Block {
    std::vector<std::vector<Placement>> parts;  // by piece
    Complex factor = 1;                         // mu^levels
    int levels = 1;
    double rate = 1, above = 1;  // of words of them: not above it, and not below

    /// Nothing where pieces do not all lead to each other, or have too many parts.
    static std::optional<Block> of(const RecurrentSet& set, std::size_t component, int levels,
                                   std::size_t most) {
        Block found;
        found.levels = levels;
        found.factor = std::pow(set.displacement().factor(), levels);
        found.parts.resize(set.size());
        const auto& letters = set.components().list[component].letters;
        for (const std::size_t piece : letters) {
            std::set<Placement> parts{{piece, 0, set.displacement().zero()}};
            for (int level = 0; level < levels; ++level) {
                std::set<Placement> next;
                for (const Placement& whole : parts)
                    for (const RecurrentSet::Part& part : parts_within(set, whole.piece))
                        next.insert(placed(set, whole, part));
                if (next.size() > most) return std::nullopt;
                parts = std::move(next);
            }
            found.parts[piece].assign(parts.begin(), parts.end());
        }
        return found.find_rate(letters) ? std::optional(std::move(found)) : std::nullopt;
    }

private:
    bool find_rate(const std::vector<std::size_t>& letters) {
        for (const std::size_t from : letters) {
            std::set<std::size_t> reached{from};
            std::vector<std::size_t> open{from};
            while (!open.empty()) {
                const std::size_t piece = open.back();
                open.pop_back();
                for (const Placement& part : parts[piece])
                    if (reached.insert(part.piece).second) open.push_back(part.piece);
            }
            if (reached.size() != letters.size()) return false;
        }
        std::vector<double> weights(parts.size(), 1), next(parts.size());
        above = INFINITY;
        for (int round = 0; round < 3000; ++round) {
            double least = INFINITY, most = 0, largest = 0;
            for (const std::size_t piece : letters) {
                double sum = 0;
                for (const Placement& part : parts[piece]) sum += weights[part.piece];
                least = std::min(least, sum / weights[piece]);
                most = std::max(most, sum / weights[piece]);
                next[piece] = sum + weights[piece];
                largest = std::max(largest, next[piece]);
            }
            rate = std::max(rate, least * (1 - rounding));
            above = std::min(above, most * (1 + rounding));
            for (const std::size_t piece : letters) weights[piece] = next[piece] / largest;
        }
        return true;
    }
};

/// The places of one piece seen from another one, in cells.
class PairCells {
public:
    PairCells(const RecurrentSet& set, const Block& block, const Budget& budget)
        : set_(set), block_(block), budget_(budget) {
        for (std::size_t piece = 0; piece < block.parts.size(); ++piece)
            if (!block.parts[piece].empty()) steps_of_same(piece);
        for (std::size_t k = 0; k < kinds_.size(); ++k) find_steps(k);
    }

    /// An upper bound of the rate of pairs of different parts that come near each other, with twice
    /// as many cells in a row as before; none where that would be too many.
    std::optional<double> refined_rate() {
        const std::vector<double> coarse = std::move(weights_);
        const std::size_t before = across_;
        across_ = before == 0 ? first_across : 2 * before;
        const std::size_t cells = across_ * across_;
        if (kinds_.size() * cells > most_cells) return std::nullopt;
        const auto weight = [&](std::size_t cell) {
            if (before == 0) return 1.0;
            const std::size_t within = cell % cells;
            return coarse[cell / cells * before * before + within / across_ / 2 * before +
                          within % across_ / 2];
        };
        // Cells that are reached, of those that lay in living ones, and what they lead to: the last
        // of the cells for one step is marked.
        constexpr std::uint32_t none = ~std::uint32_t{0}, last = std::uint32_t{1} << 31;
        std::vector<std::uint32_t> ids(kinds_.size() * cells, none);
        std::vector<std::size_t> all, begins;
        std::vector<std::uint32_t> targets;
        const auto reach = [&](std::size_t cell) {
            if (weight(cell) == 0) return false;
            if (ids[cell] == none) {
                ids[cell] = static_cast<std::uint32_t>(all.size());
                all.push_back(cell);
            }
            return true;
        };
        for (const auto& [kind, centre] : starts_) each_cell(kind, centre, 0, 1, reach);
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (k % 256 == 0) budget_.check();
            if (targets.size() > most_targets) return std::nullopt;
            const std::size_t cell = all[k];
            begins.push_back(targets.size());
            for (const Step& step : kinds_[cell / cells].steps) {
                const std::size_t begin = targets.size();
                each_cell(step.kind, step.turn * centre_of(cell) + step.shift, half(cell),
                          step.turn, [&](std::size_t to) {
                              if (reach(to)) targets.push_back(ids[to]);
                          });
                if (targets.size() > begin) targets.back() |= last;
            }
        }
        begins.push_back(targets.size());
        std::vector<double> weights, next(all.size());
        for (const std::size_t cell : all) weights.push_back(weight(cell));
        constexpr int most_rounds = 200, looked_back = 16;
        double best = INFINITY, earlier = INFINITY;
        for (int round = 0; round < most_rounds; ++round) {
            double largest = 0, radius = 0;
            for (std::size_t k = 0; k < all.size(); ++k) {
                if (k % 4096 == 0) budget_.check();
                if (weights[k] == 0) continue;
                double sum = 0, most = 0;
                for (std::size_t i = begins[k]; i < begins[k + 1]; ++i) {
                    most = std::max(most, weights[targets[i] & ~last]);
                    if (targets[i] & last) {
                        sum += most;
                        most = 0;
                    }
                }
                radius = std::max(radius, sum / weights[k]);
                next[k] = sum;
                largest = std::max(largest, sum);
            }
            best = std::min(best, radius);
            if (largest == 0) break;
            if (round % looked_back == looked_back - 1) {
                if (earlier - best < 1e-3 * best) break;
                earlier = best;
            }
            // What leads nowhere has no weight, and boundedly many pairs; what hardly leads on keeps
            // some.
            for (std::size_t k = 0; k < all.size(); ++k)
                if (weights[k] != 0)
                    weights[k] = next[k] == 0 ? 0 : std::max(next[k] / largest, 1e-200);
        }
        weights_.assign(kinds_.size() * cells, 0);
        for (std::size_t k = 0; k < all.size(); ++k) weights_[all[k]] = weights[k];
        return best * (1 + rounding);
    }

    std::size_t across() const { return across_; }

private:
    static constexpr std::size_t first_across = 12, most_cells = 50'000'000,
                                 most_targets = 120'000'000;

    struct Step {
        std::size_t kind;
        Complex turn, shift;  // of centres
    };
    struct Kind {
        std::size_t piece, other;
        std::int64_t heading;
        double reach;
        std::vector<Step> steps;
    };

    Complex direction(std::int64_t heading) const {
        return std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(heading) /
                                   static_cast<double>(set_.order()));
    }

    std::size_t number(std::size_t piece, std::size_t other, std::int64_t heading) {
        heading = normal_heading(heading, set_.order());
        const auto [place, is_new] = numbers_.try_emplace({piece, other, heading}, kinds_.size());
        if (is_new) {
            constexpr double apart = 1e-3;  // pairs farther apart than that are not near
            kinds_.push_back(
                {piece,
                 other,
                 heading,
                 (set_.disc(piece).radius + set_.disc(other).radius) * (1 + apart) + 1e-9,
                 {}});
        }
        return place->second;
    }

    /// From the pair of a piece with itself: those of different parts.
    void steps_of_same(std::size_t piece) {
        const auto& parts = block_.parts[piece];
        for (const Placement& a : parts)
            for (const Placement& b : parts) {
                if (a == b) continue;
                const Placement seen = seen_from(set_, a, b);
                starts_.emplace_back(number(a.piece, b.piece, seen.heading),
                                     set_.displacement().value(seen.offset) +
                                         direction(seen.heading) * set_.disc(b.piece).centre -
                                         set_.disc(a.piece).centre);
            }
    }

    void find_steps(std::size_t k) {
        const Kind kind = kinds_[k];
        const Complex turned = direction(kind.heading);
        // The place z of the other piece, from w = z + turned * its centre - the first centre.
        const Complex back = set_.disc(kind.piece).centre - turned * set_.disc(kind.other).centre;
        std::vector<Step> steps;
        for (const Placement& a : block_.parts[kind.piece])
            for (const Placement& b : block_.parts[kind.other]) {
                const std::int64_t heading = kind.heading + b.heading - a.heading;
                const Complex turn = direction(-a.heading);
                const Complex shift =
                    turn * (block_.factor * back + turned * set_.displacement().value(b.offset) -
                            set_.displacement().value(a.offset));
                steps.push_back({number(a.piece, b.piece, heading), turn * block_.factor,
                                 shift + direction(heading) * set_.disc(b.piece).centre -
                                     set_.disc(a.piece).centre});
            }
        kinds_[k].steps = std::move(steps);
    }

    double half(std::size_t cell) const {
        return kinds_[cell / (across_ * across_)].reach / static_cast<double>(across_);
    }

    Complex centre_of(std::size_t cell) const {
        const std::size_t within = cell % (across_ * across_);
        const double side = half(cell), reach = side * static_cast<double>(across_);
        return {side * static_cast<double>(2 * (within % across_) + 1) - reach,
                side * static_cast<double>(2 * (within / across_) + 1) - reach};
    }

    /// The cells of a kind that a square meets, of half a side times |turn|, turned so.
    template <class See>
    void each_cell(std::size_t kind, Complex centre, double half_side, Complex turn,
                   const See& see) const {
        const double reach = kinds_[kind].reach, side = 2 * reach / static_cast<double>(across_);
        const double size = half_side * std::abs(turn);
        if (std::abs(centre) > reach + size * 1.41422 + 1e-9) return;
        const double c = std::fabs(turn.real()) / std::abs(turn),
                     s = std::fabs(turn.imag()) / std::abs(turn);
        const double box = size * (c + s) + 1e-9;
        // In the frame of the turned square, cells are as wide as this.
        const double wide = size + side / 2 * (c + s) + 1e-9;
        const Complex unit = std::conj(turn) / std::abs(turn);
        const auto index = [&](double x) {
            return std::clamp(static_cast<long>(std::floor((x + reach) / side)), 0L,
                              static_cast<long>(across_) - 1);
        };
        const long left = index(centre.real() - box), right = index(centre.real() + box),
                   low = index(centre.imag() - box), high = index(centre.imag() + box);
        for (long y = low; y <= high; ++y)
            for (long x = left; x <= right; ++x) {
                const Complex at{side * (static_cast<double>(x) + 0.5) - reach,
                                 side * (static_cast<double>(y) + 0.5) - reach};
                if (std::abs(at) > reach + side * 0.70711 + 1e-9) continue;
                const Complex seen = (at - centre) * unit;
                if (std::fabs(seen.real()) > wide || std::fabs(seen.imag()) > wide) continue;
                see(kind * across_ * across_ + static_cast<std::size_t>(y) * across_ +
                    static_cast<std::size_t>(x));
            }
    }

    const RecurrentSet& set_;
    const Block& block_;
    const Budget& budget_;
    std::map<std::tuple<std::size_t, std::size_t, std::int64_t>, std::size_t> numbers_;
    std::vector<Kind> kinds_;
    std::vector<std::pair<std::size_t, Complex>> starts_;
    std::size_t across_ = 0;
    std::vector<double> weights_;  // of cells, of the last number across; 0 for dead ones
};

// Both.

constexpr int digits = 9;

Rational rounded_down(const Rational& value) {
    const Rational unit = power(Rational(10), digits);
    return Rational(floor(value * unit)) / unit;
}

Rational rounded_up(const Rational& value) { return -rounded_down(-value); }

Ball exactly_ball(double value) { return Ball(exactly(value), 128); }

class Bounds {
public:
    Bounds(const RecurrentSet& set, const Rational& within, bool with_types, const Budget& budget)
        : set_(set),
          within_(within),
          with_types_(with_types),
          budget_(budget),
          log_mu_(log(ratio())) {}

    DimensionBounds result() {
        const auto& list = set_.components().list;
        std::vector<std::size_t> order;
        for (std::size_t k = 0; k < list.size(); ++k)
            if (list[k].rate && *list[k].rate > Rate(1) &&
                set_.is_reached(list[k].letters.front()) && !is_point(set_, list[k]))
                order.push_back(k);
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return *list[a].rate > *list[b].rate;
        });
        for (const std::size_t component : order)
            open_.push_back({component, as_dimension(log(list[component].rate->enclosure(128)))});
        update_high("parts counted with multiplicity");
        try {
            run();
        } catch (const BoundReached&) {  // what was found so far
        }
        return out_;
    }

private:
    struct Open {
        std::size_t component;
        Rational high;
    };

    Ball ratio() const { return ScalingRatio(set_.displacement()).enclosure(128); }

    Rational as_dimension(const Ball& log_rate) const {
        return rounded_up((log_rate / log_mu_).upper());
    }

    bool is_near() const { return !(within_ < out_.width()); }

    void update_high(const std::string& by) {
        if (open_.empty()) return;
        Rational high = 0;
        for (const Open& open : open_)
            if (high < open.high) high = open.high;
        if (!(high < out_.high)) return;
        out_.high = high;
        out_.high_by = by;
    }

    void take_low(const Rational& low, const std::string& by) {
        if (!(out_.low < low)) return;
        out_.low = low;
        out_.low_by = by;
    }

    void run() {
        if (with_types_)
            for (Open& open : open_) exactly_known(open);
        for (Open& open : open_)
            if (out_.low < open.high && !is_near()) from_above(open);
        from_below();
    }

    void exactly_known(Open& open) {
        constexpr std::size_t few = 5'000;
        try {
            const Neighbours neighbours(set_, open.component, budget_, few);
            const Rate rate =
                neighbours.parts_coincide()
                    ? distinct_growth(set_, open.component, neighbours, budget_, few).rate
                    : *set_.components().list[open.component].rate;
            const Ball dimension = log(rate.enclosure(128)) / log_mu_;
            open.high = rounded_up(dimension.upper());
            update_high("different parts, which meet in finitely many ways");
            take_low(rounded_down(dimension.lower()),
                     "a component whose parts meet in finitely many ways");
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
        }
    }

    void from_above(Open& open) {
        const Coincidences coincidences(set_, open.component, budget_);
        if (!coincidences.found()) return;
        const std::size_t piece = set_.components().list[open.component].letters.front();
        for (int levels = 0; levels <= 12 && !is_near(); ++levels) {
            const auto rate = Kinds(set_, coincidences, levels).rate(piece, budget_);
            if (!rate) break;
            const Rational high = as_dimension(log(exactly_ball(*rate)));
            if (high < open.high) open.high = high;
            update_high("different parts, told apart by those that coincide within " +
                        counted(static_cast<std::uint64_t>(levels) + 1, "level"));
        }
    }

    /// Blocks of each component, and their cells, the coarsest first.
    struct Search {
        const Open* open;
        std::unique_ptr<Block> block;
        std::unique_ptr<PairCells> cells;
    };

    void from_below() {
        constexpr std::size_t most_parts = 40;
        std::vector<Search> searches;
        for (const Open& open : open_) {
            if (!(out_.low < open.high)) continue;
            std::optional<double> rate;
            for (int levels = 1; levels <= 3; ++levels) {
                auto block = Block::of(set_, open.component, levels, most_parts);
                // Longer blocks where that leaves coinciding parts out.
                const double own = block ? std::pow(block->rate, 1.0 / levels) : 0;
                if (!block || (rate && own > *rate * (1 - 1e-6))) continue;
                rate = own;
                auto kept = std::make_unique<Block>(std::move(*block));
                auto cells = std::make_unique<PairCells>(set_, *kept, budget_);
                searches.push_back({&open, std::move(kept), std::move(cells)});
            }
        }
        while (!searches.empty() && !is_near()) {
            std::vector<Search> left;
            for (Search& search : searches) {
                if (!(out_.low < search.open->high) || is_near()) continue;
                const auto pairs = search.cells->refined_rate();
                if (!pairs) continue;
                const Block& block = *search.block;
                const Ball low = (Ball(2, 128) * log(exactly_ball(block.rate)) -
                                  log(exactly_ball(std::max(*pairs, block.above)))) /
                                 (log_mu_ * Ball(block.levels, 128));
                const std::string across = std::to_string(search.cells->across());
                take_low(rounded_down(low.lower()),
                         "pairs of parts that may meet, in " + across + " by " + across + " cells");
                left.push_back(std::move(search));
            }
            searches = std::move(left);
        }
    }

    const RecurrentSet& set_;
    Rational within_;
    bool with_types_;
    const Budget& budget_;
    Ball log_mu_;
    std::vector<Open> open_;
    DimensionBounds out_;
};

}  // namespace

DimensionBounds dimension_bounds(const RecurrentSet& set, const Rational& within, bool with_types,
                                 const Budget& budget) {
    return Bounds(set, within, with_types, budget).result();
}

DimensionBounds dimension_bounds(const Model& system, const Rational& within,
                                 const Budget& budget) {
    if (const View<D0L> rules = as_d0l(system)) {
        std::optional<RecurrentSet> set;
        try {
            set.emplace(system, *rules, budget);
        } catch (const Error&) {  // what is known without a lattice
        }
        if (set) return dimension_bounds(*set, within, true, budget);
    }
    const ExactDimension known = exact_dimension(system, budget);
    if (!known.value) throw Error(known.conditions.back());
    DimensionBounds found;
    const Ball value = known.value->enclosure(96);
    const Rational high = rounded_up(value.upper());
    if (known.status == ExactDimension::Status::exact) {
        found.low = rounded_down(value.lower());
        found.low_by = "the exact value";
    }
    if (high < found.high) {
        found.high = high;
        found.high_by = known.status == ExactDimension::Status::exact ? "the exact value"
                                                                      : "the similarity dimension";
    }
    return found;
}

}  // namespace algae
