#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <set>

#include "dimension/detail/recurrent_set.hpp"
#include "model/model.hpp"
#include "watch/watch.hpp"

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
// What rests on doubles is proved:
// - A bound of a rate is the extreme quotient of sums of weights, whatever the weights are. They are found
//   without care; the sums and quotients are rounded outward, operation by operation (`next_above`).
// - Where a pair lies is a few products and sums of numbers of at most some size S, with errors below 2^-51 S
//   each; fewer than 2^7 of them stand between the exact numbers and the comparison of a place with the border of a
//   cell. So a margin of 2^-40 S, beside the errors of offsets that `Displacement` states, is more than enough, and no
//   cell that a pair may come to is left out. The cells of a search are exactly quarters of those before.
// - Pairs are near each other where discs meet that hold the pieces; `RecurrentSet` proves that they do.
// Logarithms at the end are in ball arithmetic.
//
// Work is counted in steps of a few nanoseconds. No clock decides how far a search comes.

namespace algae {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t most_pairs = 40'000, most_kinds = 30'000;

/// Steps that are left to a search.
class Steps {
public:
    explicit Steps(std::uint64_t left) : left_(left) {}

    void take(std::uint64_t count) {
        if (count > left_) throw BoundReached(Bound::method, "the steps of a search are used up");
        left_ -= count;
    }

private:
    std::uint64_t left_;
};

/// The spectral radius of a matrix with rows of columns, each entry 1; from above.
double radius_above(const std::vector<std::vector<std::size_t>>& rows, Steps& steps,
                    const Budget& budget) {
    constexpr int most_rounds = 2000;
    std::size_t entries = rows.size();
    for (const auto& row : rows) entries += row.size();
    std::vector<double> weights(rows.size(), 1), next(rows.size());
    double best = INFINITY;
    for (int round = 0; round < most_rounds; ++round) {
        if (round % 16 == 0) budget.check();
        steps.take(entries);
        const double radius = quotients_around(rows, weights).first;
        double largest = 0;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            double sum = weights[k];  // of the matrix and 1: periods do not matter
            for (const std::size_t column : rows[k]) sum += weights[column];
            next[k] = sum;
            largest = std::max(largest, sum);
        }
        const bool settled = best - radius < 1e-10 * best;
        best = std::min(best, radius);
        if (settled && round > 200) break;
        for (std::size_t k = 0; k < rows.size(); ++k)
            weights[k] = std::max(next[k] / largest, 1e-200);
    }
    return best;
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
        WorkCount done("coinciding pairs");
        for (std::size_t k = 0; k < pairs_.size() && pairs_.size() < most_pairs; ++k) {
            if (k % 256 == 0) budget.check();
            done.at(k);
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
                if (!may_meet(set_, at.piece, seen)) continue;
                const auto [place, is_new] =
                    numbers_.try_emplace({at.piece, std::move(seen)}, pairs_.size());
                if (is_new) {
                    pairs_.push_back(place->first);
                    before_.emplace_back();
                }
                into.push_back(place->second);
            }
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
    std::optional<double> rate(std::size_t piece, Steps& steps, const Budget& budget) {
        number({{piece, 0, set_.displacement().zero()}, {}});
        std::vector<std::vector<std::size_t>> rows;
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            budget.check();
            if (kinds_.size() > most_kinds) return std::nullopt;
            rows.push_back(parts_of(*kinds_[k], steps));
        }
        return radius_above(rows, steps, budget);
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

    std::vector<std::size_t> parts_of(const Kind& whole, Steps& steps) {
        constexpr std::uint64_t of_pair = 100;
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
            steps.take(of_pair * parts.size());
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
        for (int level = 0; level < levels; ++level) found.factor *= set.displacement().factor();
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
        std::vector<std::size_t> row_of(parts.size(), 0);
        for (std::size_t k = 0; k < letters.size(); ++k) row_of[letters[k]] = k;
        std::vector<std::vector<std::size_t>> rows(letters.size());
        for (std::size_t k = 0; k < letters.size(); ++k)
            for (const Placement& part : parts[letters[k]]) rows[k].push_back(row_of[part.piece]);
        std::vector<double> weights(rows.size(), 1), next(rows.size());
        rate = 0;
        above = INFINITY;
        for (int round = 0; round < 3000; ++round) {
            const auto [most, least] = quotients_around(rows, weights);
            rate = std::max(rate, least);
            above = std::min(above, most);
            double largest = 0;
            for (std::size_t k = 0; k < rows.size(); ++k) {
                next[k] = weights[k];
                for (const std::size_t column : rows[k]) next[k] += weights[column];
                largest = std::max(largest, next[k]);
            }
            for (std::size_t k = 0; k < rows.size(); ++k) weights[k] = next[k] / largest;
        }
        return true;
    }
};

/// The places of one piece seen from another one, in cells.
class PairCells {
public:
    /// Throws BoundReached where positions need more digits than doubles have.
    PairCells(const RecurrentSet& set, const Block& block, Steps& steps, const Budget& budget)
        : set_(set), block_(block), steps_(steps), budget_(budget) {
        for (std::size_t piece = 0; piece < block.parts.size(); ++piece)
            if (!block.parts[piece].empty()) steps_of_same(piece);
        for (std::size_t k = 0; k < kinds_.size(); ++k) find_steps(k);
        margin_ = 0x1p-40 * largest_ + 4 * error_;
        if (margin_ > 1e-6)
            throw BoundReached(Bound::digits, "the lattice of positions needs too many digits");
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
        WorkCount done("cells");
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (k % 256 == 0) budget_.check();
            done.at(k);
            if (targets.size() > most_targets) return std::nullopt;
            if (k > 0)
                steps_.take(of_target * (targets.size() - begins.back()) +
                            of_step * kinds_[all[k - 1] / cells].steps.size());
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
            steps_.take(targets.size() + all.size());
            double largest = 0, radius = 0;
            for (std::size_t k = 0; k < all.size(); ++k) {
                if (k % 4096 == 0) budget_.check();
                if (weights[k] == 0) continue;
                double sum = 0, most = 0;
                for (std::size_t i = begins[k]; i < begins[k + 1]; ++i) {
                    most = std::max(most, weights[targets[i] & ~last]);
                    if (!(targets[i] & last)) continue;
                    if (most > 0) sum = next_above(sum + most);
                    most = 0;
                }
                radius = std::max(radius, next_above(sum / weights[k]));
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
        return best;
    }

    std::size_t across() const { return across_; }

private:
    static constexpr std::size_t first_across = 12, most_cells = 50'000'000,
                                 most_targets = 120'000'000;
    static constexpr std::uint64_t of_target = 4, of_step = 8;

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
                const Complex offset = set_.displacement().value(seen.offset);
                starts_.emplace_back(number(a.piece, b.piece, seen.heading),
                                     offset +
                                         set_.direction(seen.heading) * set_.disc(b.piece).centre -
                                         set_.disc(a.piece).centre);
                take_sizes(std::abs(offset) + std::abs(set_.disc(b.piece).centre) +
                               std::abs(set_.disc(a.piece).centre),
                           set_.displacement().error(seen.offset));
            }
    }

    void take_sizes(double size, double error) {
        largest_ = std::max(largest_, size);
        error_ = std::max(error_, error);
    }

    void find_steps(std::size_t k) {
        const Kind kind = kinds_[k];
        const Complex turned = set_.direction(kind.heading);
        // The place z of the other piece, from w = z + turned * its centre - the first centre.
        const Complex back = set_.disc(kind.piece).centre - turned * set_.disc(kind.other).centre;
        const double centres =
            std::abs(set_.disc(kind.piece).centre) + std::abs(set_.disc(kind.other).centre);
        std::vector<Step> steps;
        for (const Placement& a : block_.parts[kind.piece])
            for (const Placement& b : block_.parts[kind.other]) {
                const std::int64_t heading = kind.heading + b.heading - a.heading;
                const Complex turn = set_.direction(-a.heading);
                const Complex of_a = set_.displacement().value(a.offset),
                              of_b = set_.displacement().value(b.offset);
                const Complex shift = turn * (block_.factor * back + turned * of_b - of_a);
                const std::size_t to = number(a.piece, b.piece, heading);
                steps.push_back({to, turn * block_.factor,
                                 shift + set_.direction(heading) * set_.disc(b.piece).centre -
                                     set_.disc(a.piece).centre});
                take_sizes(
                    std::abs(block_.factor) * (2 * kind.reach + centres) + std::abs(of_a) +
                        std::abs(of_b) + std::abs(set_.disc(a.piece).centre) +
                        std::abs(set_.disc(b.piece).centre) + 2 * kinds_[to].reach,
                    set_.displacement().error(a.offset) + set_.displacement().error(b.offset));
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
        if (std::abs(centre) > reach + size * 1.41422 + margin_) return;
        const double c = std::fabs(turn.real()) / std::abs(turn),
                     s = std::fabs(turn.imag()) / std::abs(turn);
        const double box = size * (c + s) + margin_;
        // In the frame of the turned square, cells are as wide as this.
        const double wide = size + side / 2 * (c + s) + margin_;
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
                if (std::abs(at) > reach + side * 0.70711 + margin_) continue;
                const Complex seen = (at - centre) * unit;
                if (std::fabs(seen.real()) > wide || std::fabs(seen.imag()) > wide) continue;
                see(kind * across_ * across_ + static_cast<std::size_t>(y) * across_ +
                    static_cast<std::size_t>(x));
            }
    }

    const RecurrentSet& set_;
    const Block& block_;
    Steps& steps_;
    const Budget& budget_;
    double largest_ = 0, error_ = 0, margin_ = 0;
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
    Bounds(const RecurrentSet& set, const BoundsSearch& search, bool with_types,
           const Budget& budget)
        : set_(set),
          search_(search),
          with_types_(with_types),
          above_steps_(search.steps / 2),
          below_steps_(search.steps / 2),
          budget_(budget),
          log_mu_(log(ratio())) {}

    DimensionBounds result() {
        const auto phases = multiplying_components(set_);
        if (phases.size() > 1) throw Error(varying);
        const auto& list = set_.components().list;
        for (const std::size_t component : phases.front())
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
        std::unique_ptr<Coincidences> coincidences = {};
        bool is_done = false;  // from above
    };

    Ball ratio() const { return ScalingRatio(set_.displacement()).enclosure(128); }

    Rational as_dimension(const Ball& log_rate) const {
        return rounded_up((log_rate / log_mu_).upper());
    }

    bool is_enough() const { return search_.is_enough && search_.is_enough(out_); }

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

    /// The searches from both sides take turns, with ever more levels and smaller cells.
    void run() {
        if (is_enough()) return;
        if (with_types_)
            for (Open& open : open_) exactly_known(open);
        std::vector<Below> below;
        for (int round = 0; !is_enough(); ++round) {
            bool goes_on = false;
            for (Open& open : open_)
                if (out_.low < open.high && !open.is_done && !is_enough()) {
                    open.is_done = !within_steps([&] { return from_above(open, round); });
                    goes_on = goes_on || !open.is_done;
                }
            if (round == 0) below = begin_below();
            for (Below& each : below)
                if (!each.is_done && out_.low < each.open->high && !is_enough()) {
                    each.is_done = !within_steps([&] { return refine(each); });
                    goes_on = goes_on || !each.is_done;
                }
            if (!goes_on) return;
        }
    }

    /// What the search says of going on; no where it may not.
    template <class Search>
    static bool within_steps(const Search& search) {
        try {
            return search();
        } catch (const BoundReached& bound) {
            if (bound.bound() == Bound::time) throw;
            return false;
        }
    }

    void exactly_known(Open& open) {
        constexpr std::size_t few = 2'000;
        within_steps([&] {
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
            return true;
        });
    }

    /// Whether it goes on.
    bool from_above(Open& open, int levels) {
        constexpr int most_levels = 12;
        if (!open.coincidences)
            open.coincidences = std::make_unique<Coincidences>(set_, open.component, budget_);
        if (!open.coincidences->found()) return false;
        const std::size_t piece = set_.components().list[open.component].letters.front();
        const auto rate =
            Kinds(set_, *open.coincidences, levels).rate(piece, above_steps_, budget_);
        if (!rate) return false;
        const Rational high = as_dimension(log(exactly_ball(*rate)));
        if (high < open.high) open.high = high;
        update_high("different parts, told apart by those that coincide within " +
                    counted(static_cast<std::uint64_t>(levels) + 1, "level"));
        return levels < most_levels;
    }

    /// The blocks of a component, and their cells.
    struct Below {
        const Open* open;
        std::unique_ptr<Block> block;
        std::unique_ptr<PairCells> cells;
        bool is_done = false;
    };

    std::vector<Below> begin_below() {
        constexpr std::size_t most_parts = 40;
        std::vector<Below> found;
        for (const Open& open : open_) {
            if (!(out_.low < open.high)) continue;
            std::optional<double> rate;
            for (int levels = 1; levels <= 3; ++levels) {
                auto block = Block::of(set_, open.component, levels, most_parts);
                // Longer blocks where that leaves coinciding parts out.
                const double own = block ? std::pow(block->rate, 1.0 / levels) : 0;
                if (!block || (rate && own > *rate * (1 - 1e-6))) continue;
                rate = own;
                within_steps([&] {
                    auto kept = std::make_unique<Block>(std::move(*block));
                    auto cells = std::make_unique<PairCells>(set_, *kept, below_steps_, budget_);
                    found.push_back({&open, std::move(kept), std::move(cells)});
                    return true;
                });
            }
        }
        return found;
    }

    /// Whether it goes on.
    bool refine(Below& search) {
        const auto pairs = search.cells->refined_rate();
        if (!pairs) return false;
        const Block& block = *search.block;
        const Ball low = (Ball(2, 128) * log(exactly_ball(block.rate)) -
                          log(exactly_ball(std::max(*pairs, block.above)))) /
                         (log_mu_ * Ball(block.levels, 128));
        const std::string across = std::to_string(search.cells->across());
        take_low(rounded_down(low.lower()),
                 "pairs of parts that may meet, in " + across + " by " + across + " cells");
        return true;
    }

    const RecurrentSet& set_;
    const BoundsSearch& search_;
    bool with_types_;
    Steps above_steps_, below_steps_;
    const Budget& budget_;
    Ball log_mu_;
    std::vector<Open> open_;
    DimensionBounds out_;
};

}  // namespace

std::pair<double, double> quotients_around(const std::vector<std::vector<std::size_t>>& rows,
                                           const std::vector<double>& weights) {
    double above = 0, below = INFINITY;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        double more = 0, less = 0;
        for (const std::size_t column : rows[k]) {
            more = next_above(more + weights[column]);
            less = next_below(less + weights[column]);
        }
        above = std::max(above, next_above(more / weights[k]));
        below = std::min(below, next_below(less / weights[k]));
    }
    return {above, below};
}

DimensionBounds dimension_bounds(const RecurrentSet& set, const BoundsSearch& search,
                                 bool with_types, const Budget& budget) {
    return Bounds(set, search, with_types, budget).result();
}

DimensionBounds dimension_bounds(const Model& system, const BoundsSearch& search,
                                 const Budget& budget) {
    if (const View<D0L> rules = as_d0l(system)) {
        std::optional<RecurrentSet> set;
        try {
            set.emplace(system, *rules, budget);
        } catch (const Error&) {  // what is known without a lattice
        }
        if (set) return dimension_bounds(*set, search, true, budget);
    }
    const ExactDimension known = exact_dimension(system, budget);
    if (!known.value) throw Error(known.conditions.back());
    if (known.almost_surely)
        throw Error("chance has a part in what is drawn: no bounds hold for all that it may be");
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
