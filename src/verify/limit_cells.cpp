#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/limit_set.hpp"

// Two proofs by cells: of the boundary of a limit set, and of a lower bound of its dimension.
//
// The boundary. Let L be a lattice of the plane with all positions of parts in it, that nu = mu zeta^shift maps to itself for some number of
// turns, and D a complete system of residues modulo nu. The tile T with nu T = union of T + d has copies T + z, z in L, that cover the
// plane, no point more often than a bounded number of times (Lagarias and Wang 1996). The positions lie in L, so the ways in
// which parts meet copies of T are finitely many, and so are the sets of parts that meet one copy, which are the states. A copy is full, that is it
// lies in the set, if no copy of a later level within it meets nothing. Every point of the boundary lies in copies that meet the set
// and are not full, and each of those is near the boundary: their rate gives its dimension.
//
// The lower bound. Every code of n blocks, each of some levels, has the same share of the mass but for constant factors. If pairs of
// parts that lie near each other multiply by q in each block, and codes by r, the energy of the mass is finite for every exponent below
// (2 log r - log max(q, r)) / log |mu|^levels (Frostman). A pair is known by the place of the one piece seen from the other, in a disc that is
// cut into square cells; the cells that the pairs of their parts come to follow. With a positive weight for each cell, such that
// the sum, over the pairs of parts, of the largest weight of a cell that they come to is less than q times its own, pairs multiply by less
// than q. Places are whole numbers of units of 2^-22 here; products are shortened, and cells made wider by a margin that is
// larger than all errors together.

namespace algae::verify::limits {

namespace {

constexpr std::size_t most_pairs = 60'000, most_states = 60'000;

// The boundary.

struct Place {
    std::int64_t x = 0, y = 0;
    auto operator<=>(const Place&) const = default;
    friend Place operator+(Place a, Place b) { return {a.x + b.x, a.y + b.y}; }
    friend Place operator-(Place a, Place b) { return {a.x - b.x, a.y - b.y}; }
};

constexpr std::int64_t largest_coordinate = std::int64_t{1} << 28;

Place checked(Place at) {
    if (std::abs(at.x) > largest_coordinate || std::abs(at.y) > largest_coordinate)
        too_hard("positions in a lattice are too large");
    return at;
}

/// A tiling of the plane by copies of a tile, which the factor of a set refines.
class Tiling {
public:
    explicit Tiling(const Places& places) : set_(places.set) {
        for (shift_ = 0; shift_ < set_.order; ++shift_) {
            places.task.budget.check();
            if (!find_lattice()) continue;
            find_digits();
            find_disc();
            return;
        }
        too_hard("positions of parts lie in no lattice of the plane");
    }

    std::int64_t shift() const { return shift_; }
    const std::vector<Place>& digits() const { return digits_; }
    const Number& centre() const { return centre_; }
    const Ball& radius() const { return radius_; }

    Number value(Place at) const {
        return number(Rational(at.x)) * values_[0] + number(Rational(at.y)) * values_[1];
    }
    Place scaled(Place at) const {
        return checked(
            {at.x * scale_[0].x + at.y * scale_[1].x, at.x * scale_[0].y + at.y * scale_[1].y});
    }
    /// Of a row in the basis; nothing if they are not whole.
    std::optional<Place> coordinates(const Row& row) const {
        const auto minor = [](const Row& a, const Row& b, std::size_t i, std::size_t k) {
            return a[i] * b[k] - a[k] * b[i];
        };
        for (std::size_t i = 0; i < row.size(); ++i)
            for (std::size_t k = i + 1; k < row.size(); ++k) {
                const Integer whole = minor(basis_[0], basis_[1], i, k);
                if (whole.is_zero()) continue;
                const Rational x(minor(row, basis_[1], i, k), whole),
                    y(minor(basis_[0], row, i, k), whole);
                if (!x.is_integer() || !y.is_integer()) return std::nullopt;
                Row sum(row.size());
                for (std::size_t c = 0; c < row.size(); ++c)
                    sum[c] = x.numerator() * basis_[0][c] + y.numerator() * basis_[1][c];
                if (sum != row) return std::nullopt;
                if (!x.numerator().fits_int64() || !y.numerator().fits_int64())
                    too_hard("positions in a lattice are too large");
                return checked({x.numerator().to_int64(), y.numerator().to_int64()});
            }
        return std::nullopt;
    }

    /// All points of the lattice that are not seen to be farther than that from a number, and perhaps more.
    std::vector<Place> near(const Number& at, const Ball& distance) const {
        constexpr std::int64_t widest = 3000;
        const auto range = [&](const Ball& middle, const Number& other) {
            const Ball away = abs(distance * size(other) / area_);
            const Integer low = floor((middle - away).lower()),
                          high = ceiling((middle + away).upper());
            if (Integer(widest) < high - low) too_hard("the set meets too many cells");
            return std::pair(low.to_int64(), high.to_int64());
        };
        const auto [left, right] = range(cross(at, values_[1]) / area_, values_[1]);
        const auto [bottom, top] = range(cross(values_[0], at) / area_, values_[0]);
        std::vector<Place> found;
        for (std::int64_t x = left; x <= right; ++x)
            for (std::int64_t y = bottom; y <= top; ++y) found.push_back(checked({x, y}));
        return found;
    }

private:
    static Ball cross(const Number& a, const Number& b) {
        return a.real * b.imaginary - a.imaginary * b.real;
    }

    /// The positions of parts in a frame that turns by the shift in each level.
    std::vector<Row> moves() const {
        std::set<std::pair<std::size_t, std::int64_t>> pieces;
        std::vector<std::pair<std::size_t, std::int64_t>> open;
        std::set<Row> found;
        const auto visit = [&](std::size_t piece, std::int64_t heading) {
            if (pieces.emplace(piece, set_.normal(heading)).second)
                open.emplace_back(piece, set_.normal(heading));
        };
        for (const Seen& part : set_.axiom) {
            Row offset = part.offset;
            add(offset, set_.axiom.front().offset, true);
            found.insert(std::move(offset));
            visit(part.piece, part.heading);
        }
        while (!open.empty()) {
            const auto [piece, heading] = open.back();
            open.pop_back();
            for (const Seen& part : set_.parts.at(piece)) {
                found.insert(set_.turned(part.offset, heading + shift_));
                visit(part.piece, heading + shift_ + part.heading);
            }
        }
        found.erase(Row(set_.rank));
        return {found.begin(), found.end()};
    }

    Row refined(const Row& row) const { return set_.turned(row * set_.scale, shift_); }

    /// Whether there is a lattice of the plane in this frame.
    bool find_lattice() {
        std::vector<Row> rows = moves();
        if (rows.empty()) return false;
        for (int round = 0; round < 64; ++round) {
            const IntegerMatrix reduced = lattice_basis(IntegerMatrix(rows));
            if (reduced.rows() > 2) return false;
            basis_.clear();
            for (std::size_t i = 0; i < reduced.rows(); ++i) {
                Row row(set_.rank);
                for (std::size_t k = 0; k < set_.rank; ++k) row[k] = reduced(i, k);
                basis_.push_back(std::move(row));
            }
            rows = basis_;
            for (const Row& row : basis_)
                if (basis_.size() < 2 || !coordinates(refined(row))) rows.push_back(refined(row));
            if (rows.size() > basis_.size()) continue;
            shorten();
            values_ = {set_.value(basis_[0]), set_.value(basis_[1])};
            area_ = cross(values_[0], values_[1]);
            if (area_.contains(Rational(0))) return false;  // all on a line, or not seen to be none
            for (std::size_t i = 0; i < 2; ++i) scale_[i] = coordinates(refined(basis_[i])).value();
            return true;
        }
        return false;
    }

    /// Gauss's reduction: how short the vectors are decides only how much work there is.
    void shorten() {
        for (int round = 0; round < 100; ++round) {
            const auto near = [&](const Row& row) {
                const Number at = set_.value(row);
                return std::pair(at.real.midpoint(), at.imaginary.midpoint());
            };
            const auto [a, b] = near(basis_[0]);
            const auto [c, d] = near(basis_[1]);
            const double first = a * a + b * b, second = c * c + d * d;
            if (!(first > 0)) return;
            if (second < first * (1 - 1e-9)) {
                std::swap(basis_[0], basis_[1]);
                continue;
            }
            const double times = std::round((a * c + b * d) / first);
            if (times == 0 || !(std::abs(times) < 1e9)) return;
            for (std::size_t k = 0; k < set_.rank; ++k)
                basis_[1][k] -= Integer(static_cast<std::int64_t>(times)) * basis_[0][k];
        }
    }

    /// A complete system of residues, each short.
    void find_digits() {
        constexpr std::int64_t most_digits = 2048;
        const std::int64_t determinant =
            std::abs(scale_[0].x * scale_[1].y - scale_[0].y * scale_[1].x);
        if (determinant > most_digits) too_hard("a cell has too many parts");
        // A place is a multiple of nu if it times the adjoint matrix is one of the determinant.
        const auto key = [&](Place at) {
            const auto residue = [&](std::int64_t x) {
                return (x % determinant + determinant) % determinant;
            };
            return Place{residue(at.x * scale_[1].y - at.y * scale_[1].x),
                         residue(at.y * scale_[0].x - at.x * scale_[0].y)};
        };
        std::set<Place> seen;
        for (std::int64_t around = 0; static_cast<std::int64_t>(digits_.size()) < determinant;
             ++around)
            for (std::int64_t x = -around; x <= around; ++x)
                for (std::int64_t y = -around; y <= around; ++y)
                    if (std::max(std::abs(x), std::abs(y)) == around &&
                        seen.insert(key({x, y})).second)
                        digits_.push_back({x, y});
    }

    /// A disc around the tile: the parts of it lie in it.
    void find_disc() {
        const Number nu = set_.factor * set_.zeta(shift_);
        Number middle = number(0);
        for (const Place digit : digits_) middle = middle + value(digit);
        middle =
            middle / (number(Rational(Integer(std::uint64_t{digits_.size()}))) * (nu - number(1)));
        centre_ = number(exactly(middle.real.midpoint()), exactly(middle.imaginary.midpoint()));
        Ball farthest(0, bits);
        for (const Place digit : digits_) {
            const Ball away = size(value(digit) + centre_ - nu * centre_);
            farthest = is_above(away, farthest) ? away : hull(farthest, away);
        }
        radius_ = Ball((farthest / (size(nu) - Ball(1, bits))).upper(), bits);
    }

    const LimitSet& set_;
    std::int64_t shift_ = 0;
    std::vector<Row> basis_;
    std::vector<Number> values_;
    Ball area_{0, bits};
    std::array<Place, 2> scale_;
    std::vector<Place> digits_;
    Number centre_ = number(0);
    Ball radius_{0, bits};
};

class Boundary {
public:
    explicit Boundary(const Places& places) : places_(places), set_(places.set), tiling_(places) {
        if (set_.discs.empty()) places.task.proof.refuse("the pieces have no discs");
    }

    Operand rate() {
        find_pairs();
        leave_out_dead_ends();
        find_states();
        return rate_of_paths(partly_covered(), places_.task.budget);
    }

private:
    using Turned = std::pair<std::size_t, std::int64_t>;  // a piece and its heading
    using Pair = std::pair<Turned, Place>;  // where it lies, seen from a copy of the tile

    /// The number of a pair that may meet.
    std::optional<std::size_t> number_of(const Turned& piece, Place at) {
        const auto known = numbers_.find({piece, at});
        if (known != numbers_.end()) return known->second;
        const Disc& disc = set_.discs.at(piece.first);
        if (is_above(
                size(tiling_.value(at) + set_.zeta(piece.second) * disc.centre - tiling_.centre()),
                disc.radius + tiling_.radius()))
            return std::nullopt;
        if (pairs_.size() == most_pairs) too_hard("parts meet cells in too many ways");
        numbers_.emplace(Pair{piece, at}, pairs_.size());
        pairs_.push_back({piece, at});
        return pairs_.size() - 1;
    }

    Place place_of(const Row& row) const {
        const auto found = tiling_.coordinates(row);
        if (!found) throw Error("a part lies beside its lattice");
        return *found;
    }

    void find_pairs() {
        for (const Seen& part : set_.axiom) {
            Row offset = part.offset;
            add(offset, set_.axiom.front().offset, true);
            const Place by = place_of(offset);
            const Turned piece{part.piece, set_.normal(part.heading)};
            const Disc& disc = set_.discs.at(part.piece);
            const Number middle =
                tiling_.value(by) + set_.zeta(part.heading) * disc.centre - tiling_.centre();
            for (const Place cell : tiling_.near(middle, disc.radius + tiling_.radius()))
                if (const auto pair = number_of(piece, by - cell)) starts_[cell].push_back(*pair);
        }
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            if (k % 64 == 0) places_.task.budget.check();
            const auto [turned, at] = pairs_[k];
            const auto [piece, heading] = turned;
            auto& next = next_.emplace_back();
            for (const Seen& part : set_.parts.at(piece)) {
                const Place by = tiling_.scaled(at) +
                                 place_of(set_.turned(part.offset, heading + tiling_.shift()));
                const Turned to{part.piece, set_.normal(heading + tiling_.shift() + part.heading)};
                for (std::size_t d = 0; d < tiling_.digits().size(); ++d)
                    if (const auto pair = number_of(to, checked(by - tiling_.digits()[d])))
                        next.emplace_back(d, *pair);
            }
        }
    }

    /// A pair meets exactly if an endless path begins at it.
    void leave_out_dead_ends() {
        lives_.assign(pairs_.size(), true);
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t k = pairs_.size(); k-- > 0;) {
                if (!lives_[k] || std::any_of(next_[k].begin(), next_[k].end(),
                                              [&](const auto& to) { return lives_[to.second]; }))
                    continue;
                lives_[k] = false;
                changed = true;
            }
        }
    }

    static constexpr std::size_t nothing = ~std::size_t{0};

    std::size_t state_of(std::set<std::size_t> pairs) {
        std::erase_if(pairs, [&](std::size_t pair) { return !lives_[pair]; });
        if (pairs.empty()) return nothing;
        const auto [place, is_new] = state_numbers_.try_emplace(std::move(pairs), states_.size());
        if (is_new) {
            if (states_.size() == most_states) too_hard("parts meet cells in too many ways");
            states_.push_back(&place->first);
        }
        return place->second;
    }

    void find_states() {
        for (const auto& [cell, pairs] : starts_) state_of({pairs.begin(), pairs.end()});
        for (std::size_t k = 0; k < states_.size(); ++k) {
            if (k % 64 == 0) places_.task.budget.check();
            std::vector<std::set<std::size_t>> parts(tiling_.digits().size());
            for (const std::size_t pair : *states_[k])
                for (const auto& [digit, next] : next_[pair]) parts[digit].insert(next);
            std::vector<std::size_t> next;
            for (auto& part : parts) next.push_back(state_of(std::move(part)));
            covers_.push_back(std::move(next));
        }
    }

    /// The states of cells that the set meets and does not hold.
    Graph partly_covered() const {
        std::vector<bool> is_partly(covers_.size(), false);
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t k = covers_.size(); k-- > 0;)
                if (!is_partly[k] &&
                    std::any_of(covers_[k].begin(), covers_[k].end(), [&](std::size_t next) {
                        return next == nothing || is_partly[next];
                    }))
                    is_partly[k] = changed = true;
        }
        if (std::find(is_partly.begin(), is_partly.end(), false) == is_partly.end())
            places_.task.refuse("the set has no inner points");
        Graph found(covers_.size());
        for (std::size_t k = covers_.size(); k-- > 0;)
            if (is_partly[k])  // what comes of others comes to an end
                for (const std::size_t next : covers_[k])
                    if (next != nothing) found[k].push_back(next);
        return found;
    }

    const Places& places_;
    const LimitSet& set_;
    Tiling tiling_;
    std::vector<Pair> pairs_;
    std::map<Pair, std::size_t> numbers_;
    std::vector<std::vector<std::pair<std::size_t, std::size_t>>> next_;  // part of the cell, pair
    std::vector<bool> lives_;
    std::map<Place, std::vector<std::size_t>> starts_;  // by cell
    std::map<std::set<std::size_t>, std::size_t> state_numbers_;
    std::vector<const std::set<std::size_t>*> states_;
    Graph covers_;  // by state: the states of the parts of the cell
};

// Pairs of parts.

constexpr int digits_behind = 22;
constexpr std::int64_t unit = std::int64_t{1} << digits_behind;
constexpr std::int64_t margin = 1 << 12;  // about 1/1000

std::int64_t shortened(std::int64_t product) { return product >> digits_behind; }

/// A place in units, off by at most 2 of them.
struct Fixed {
    std::int64_t x = 0, y = 0;
};

std::int64_t fixed(const Ball& value, std::int64_t most) {
    const Integer found = floor(value.lower() * Rational(Integer(unit)));
    if (!value.has_radius_below(-digits_behind)) too_hard("places are not known well enough");
    if (!(abs(found) < Integer(most * unit))) too_hard("pieces are too large for cells");
    return found.to_int64();
}

constexpr std::int64_t most_size = 120, most_stretch = 31;

/// By piece: the different parts of some levels.
using Blocks = std::map<std::size_t, std::vector<Seen>>;

Blocks blocks_of(const Parts& parts, std::uint64_t levels) {
    constexpr std::size_t most_parts = 40;
    Blocks blocks;
    for (const std::size_t piece : parts.component().pieces) {
        std::set<Seen> found{parts.here(piece)};
        for (std::uint64_t level = 0; level < levels; ++level) {
            std::set<Seen> next;
            for (const Seen& whole : found)
                for (Seen& part : parts.of(whole)) next.insert(std::move(part));
            if (next.size() > most_parts) too_hard("a block has too many parts");
            found = std::move(next);
        }
        blocks[piece].assign(found.begin(), found.end());
    }
    return blocks;
}

/// The places of one piece seen from another one, in cells.
class PairsInCells {
public:
    PairsInCells(Parts& parts, std::uint64_t levels, std::uint64_t across, const Budget& budget)
        : set_(parts.set()),
          across_(static_cast<std::int64_t>(across)),
          budget_(budget),
          blocks_(blocks_of(parts, levels)) {
        stretch_ = number(1);
        for (std::uint64_t level = 0; level < levels; ++level) stretch_ = stretch_ * set_.factor;
        for (const auto& [piece, own] : blocks_)
            for (std::size_t i = 0; i < own.size(); ++i)
                for (std::size_t k = i + 1; k < own.size(); ++k) begin_with(own[i], own[k]);
        for (std::size_t k = 0; k < cells_.size(); ++k) {
            if (k % 64 == 0) budget_.check();
            follow(k);
        }
    }

    bool multiply_below(const Rational& number) const {
        return grows_below(
            cells_.size(), number,
            [&](std::size_t cell, const std::vector<std::uint64_t>& weights) {
                std::uint64_t sum = 0, largest = 0;
                for (std::size_t i = begins_[cell]; i < begins_[cell + 1]; ++i) {
                    if (targets_[i] == end_of_step) {
                        sum += largest;
                        largest = 0;
                    } else {
                        largest = std::max(largest, weights[targets_[i]]);
                    }
                }
                return sum;
            },
            budget_);
    }

private:
    static constexpr std::uint32_t end_of_step = ~std::uint32_t{0}, nowhere = end_of_step;
    static constexpr std::size_t most_targets = 30'000'000;

    /// From a pair of pieces to that of a part of each: w becomes by * w + shift.
    struct Step {
        std::size_t to;
        Fixed by, shift;
    };
    struct Kind {
        std::size_t first, other;
        std::int64_t heading;
        std::int64_t reach, half;  // of the disc of places, and half a cell's side
        bool has_steps = false;
        std::vector<Step> steps = {};
    };

    const Disc& disc(std::size_t piece) const {
        if (set_.discs.empty()) too_hard("the pieces have no discs");
        return set_.discs.at(piece);
    }

    static Fixed fixed_place(const Number& at, std::int64_t most) {
        return {fixed(at.real, most), fixed(at.imaginary, most)};
    }

    std::size_t kind_of(std::size_t first, std::size_t other, std::int64_t heading) {
        const auto [place, is_new] =
            kind_numbers_.try_emplace({first, other, set_.normal(heading)}, kinds_.size());
        if (is_new) {
            const std::int64_t reach =
                fixed(disc(first).radius + disc(other).radius, most_size / 2) + margin;
            kinds_.push_back({first, other, set_.normal(heading), reach, reach / across_ + 1});
            cell_numbers_.emplace_back();
        }
        return place->second;
    }

    std::size_t cell(std::size_t kind, std::int64_t x, std::int64_t y) {
        constexpr std::size_t most_cells = 4'000'000;
        auto& numbers = cell_numbers_[kind];
        if (numbers.empty()) numbers.assign(static_cast<std::size_t>(across_ * across_), nowhere);
        std::uint32_t& number = numbers[static_cast<std::size_t>(y * across_ + x)];
        if (number == nowhere) {
            if (cells_.size() == most_cells) too_hard("there are too many cells");
            number = static_cast<std::uint32_t>(cells_.size());
            cells_.push_back({kind, x, y});
        }
        return number;
    }

    Fixed centre(std::size_t kind, std::int64_t x, std::int64_t y) const {
        const std::int64_t half = kinds_[kind].half;
        return {half * (2 * x + 1 - across_), half * (2 * y + 1 - across_)};
    }

    /// The cells of a kind that a square may meet: around `at`, with the sides `by` times those of cells of half a side `half`.
    template <class See>
    void each_cell(std::size_t kind, Fixed at, Fixed by, std::int64_t half, const See& see) {
        const std::int64_t reach = kinds_[kind].reach, own = kinds_[kind].half;
        const std::int64_t spread = std::abs(by.x) + std::abs(by.y);
        const std::int64_t wide = shortened(half * spread) + margin;
        const auto index = [&](std::int64_t place) {
            const std::int64_t from = place + own * across_;
            return std::clamp(from < 0 ? std::int64_t{-1} : from / (2 * own), std::int64_t{0},
                              across_ - 1);
        };
        const auto is_beyond = [&](std::int64_t place) {
            return place - wide > own * across_ || place + wide < -own * across_;
        };
        if (is_beyond(at.x) || is_beyond(at.y)) return;
        // In the frame of the turned square.
        const std::int64_t square = shortened(by.x * by.x + by.y * by.y);
        const std::int64_t turned_wide =
            shortened(square * half) + shortened(own * spread) + margin * (spread / unit + 2);
        for (std::int64_t y = index(at.y - wide); y <= index(at.y + wide); ++y)
            for (std::int64_t x = index(at.x - wide); x <= index(at.x + wide); ++x) {
                const Fixed middle = centre(kind, x, y);
                const std::int64_t around = reach + own + own / 2;
                if (middle.x * middle.x + middle.y * middle.y > around * around) continue;
                const Fixed away{middle.x - at.x, middle.y - at.y};
                if (std::abs(shortened(away.x * by.x + away.y * by.y)) > turned_wide ||
                    std::abs(shortened(away.y * by.x - away.x * by.y)) > turned_wide)
                    continue;
                see(x, y);
            }
    }

    void begin_with(const Seen& first, const Seen& other) {
        const Seen seen = set_.seen_from(first, other);
        const Number at = set_.value(seen.offset) +
                          set_.zeta(seen.heading) * disc(seen.piece).centre -
                          disc(first.piece).centre;
        const std::size_t kind = kind_of(first.piece, seen.piece, seen.heading);
        if (is_above(size(at), disc(first.piece).radius + disc(seen.piece).radius +
                                   Ball(Rational(Integer(margin), Integer(unit)), bits)))
            return;
        each_cell(kind, fixed_place(at, most_size), {unit, 0}, 1,
                  [&](std::int64_t x, std::int64_t y) { cell(kind, x, y); });
    }

    void find_steps(std::size_t k) {
        if (kinds_[k].has_steps) return;
        const Kind kind = kinds_[k];
        const Number back =
            disc(kind.first).centre - set_.zeta(kind.heading) * disc(kind.other).centre;
        std::vector<Step> steps;
        for (const Seen& a : blocks_.at(kind.first))
            for (const Seen& b : blocks_.at(kind.other)) {
                const Number turn = set_.zeta(-a.heading);
                const std::int64_t heading = kind.heading + b.heading - a.heading;
                const Number shift =
                    turn * (stretch_ * back + set_.zeta(kind.heading) * set_.value(b.offset) -
                            set_.value(a.offset)) +
                    set_.zeta(heading) * disc(b.piece).centre - disc(a.piece).centre;
                const std::size_t to = kind_of(a.piece, b.piece, heading);
                steps.push_back({to, fixed_place(turn * stretch_, most_stretch),
                                 fixed_place(shift, most_size * most_stretch)});
            }
        kinds_[k].steps = std::move(steps);
        kinds_[k].has_steps = true;
    }

    void follow(std::size_t k) {
        const auto [kind, x, y] = cells_[k];
        find_steps(kind);
        const Fixed at = centre(kind, x, y);
        const std::int64_t half = kinds_[kind].half;
        begins_.push_back(targets_.size());
        for (const Step& step : kinds_[kind].steps) {
            const Fixed image{shortened(step.by.x * at.x - step.by.y * at.y) + step.shift.x,
                              shortened(step.by.x * at.y + step.by.y * at.x) + step.shift.y};
            const std::size_t before = targets_.size(), to = step.to;
            each_cell(to, image, step.by, half, [&](std::int64_t i, std::int64_t j) {
                targets_.push_back(static_cast<std::uint32_t>(cell(to, i, j)));
            });
            if (targets_.size() > before) targets_.push_back(end_of_step);
            if (targets_.size() > most_targets) too_hard("there are too many cells");
        }
        if (k % 1024 == 0)
            budget_.check_memory(targets_.size() * 4 + cells_.size() * 120, "the cells of pairs");
        if (k + 1 == cells_.size()) begins_.push_back(targets_.size());
    }

    const LimitSet& set_;
    std::int64_t across_;
    const Budget& budget_;
    Blocks blocks_;
    Number stretch_ = number(1);
    std::map<std::tuple<std::size_t, std::size_t, std::int64_t>, std::size_t> kind_numbers_;
    std::vector<Kind> kinds_;
    std::vector<std::vector<std::uint32_t>> cell_numbers_;  // by kind; `nowhere` if not reached
    std::vector<std::tuple<std::size_t, std::int64_t, std::int64_t>> cells_;
    std::vector<std::size_t> begins_;     // by cell, where its targets begin
    std::vector<std::uint32_t> targets_;  // of each pair of parts, one after the other
};

}  // namespace

Operand rate_of_boundary(const Places& places) {
    if (places.set.phases > 1) too_hard("late generations approach several sets in turn");
    return Boundary(places).rate();
}

Operand rate_of_blocks(const Parts& parts, std::uint64_t levels, const Budget& budget) {
    const Blocks blocks = blocks_of(parts, levels);
    std::map<std::size_t, std::size_t> numbers;
    for (const auto& [piece, own] : blocks) numbers.emplace(piece, numbers.size());
    Graph graph(numbers.size());
    for (const auto& [piece, own] : blocks)
        for (const Seen& part : own) graph[numbers.at(piece)].push_back(numbers.at(part.piece));
    if (strong_components(graph).size() != 1)
        too_hard("pieces do not all lead to each other in blocks of levels");
    return rate_of_paths(graph, budget);
}

bool is_above_by_pairs(Parts& parts, std::uint64_t levels, std::uint64_t across, const Ball& number,
                       const Budget& budget) {
    const Ball rate = rate_of_blocks(parts, levels, budget).enclose(bits);
    // The energy is finite below the number, and a little above it, if pairs and codes multiply by less than this.
    const Ball most = exp(Ball(2, bits) * log(rate) - Ball(Integer(levels), bits) * number *
                                                          log(parts.set().ratio.enclose(bits)));
    if (!is_above(most, rate)) return false;
    return PairsInCells(parts, levels, across, budget).multiply_below(most.lower());
}

}  // namespace algae::verify::limits
