#include <algorithm>
#include <cmath>

#include "dimension/detail/recurrent_set.hpp"
#include "watch/watch.hpp"

// Where do the parts of a recurrent set meet, and which of them coincide?
//
// Two parts of one level that lie too far apart never meet below. Seen from one of them, the other
// is a `Placement`: piece, heading and exact offset. From a pair follow the pairs of their parts; a
// pair is dropped as soon as the discs of the two are disjoint. If only finitely many pairs arise,
// the set has finite type (Bandt and Graf 1992; Strichartz and Wang 1999; Ngai and Wang 2001).
// Pairs without successors are removed at the end, so two pieces meet exactly if their pair is
// left. The search cannot know beforehand whether it ends, so it is bounded by a number of pairs
// and by the budget.
//
// If no pair is one of a piece with itself in the same place, no parts coincide, the number of
// pieces that meet in one place is bounded, and all parts count: the dimension of the component is
// log rate / log |mu|. Otherwise the different parts are counted (`distinct_growth`): a part is
// told apart by its surroundings, the other parts that may still coincide with parts of it. The
// surroundings of the parts of a part follow from its own, so there are finitely many kinds, and a
// part that k parts share counts 1/k for each. The rate of this matrix is that of the different
// parts, and an algebraic integer, because it is the rate of a sequence of integers (Fatou).

namespace algae {

namespace {

void add_row(GrowthMatrix& matrix, const std::map<std::size_t, Integer>& counts) {
    auto& row = matrix.rows.emplace_back();
    for (const auto& [column, times] : counts) row.push_back({column, times});
}

/// A number that no eigenvalue of the matrix reaches: one more than the largest sum of a row.
Rational above_all(const GrowthMatrix& matrix) {
    Integer widest = 1;
    for (const auto& row : matrix.rows) {
        Integer sum;
        for (const auto& entry : row) sum += entry.times;
        if (widest < sum) widest = sum;
    }
    return Rational(widest + 1);
}

/// Whether the two pieces of a pair are the same one in the same place.
bool is_one_place(const Neighbours::Pair& pair) {
    const auto& [piece, heading, offset] = pair.other;
    return pair.piece == piece && heading == 0 &&
           std::all_of(offset.begin(), offset.end(), [](std::int64_t x) { return x == 0; });
}

}  // namespace

bool may_meet(const RecurrentSet& set, std::size_t piece, const Placement& other) {
    // Fewer than 2^4 roundings, each by at most 2^-52 of the largest number; where the discs come
    // together, the offset is at most as large as the rest of the sum.
    constexpr double margin = 1e-6, rounding = 0x1p-46;
    const auto& first = set.disc(piece);
    const auto& second = set.disc(other.piece);
    const double reach = first.radius + second.radius;
    const double sizes = reach + std::abs(first.centre) + std::abs(second.centre);
    const std::complex<double> centre =
        set.displacement().value(other.offset) + set.direction(other.heading) * second.centre;
    return std::abs(centre - first.centre) <=
           reach + margin + rounding * sizes + set.displacement().error(other.offset);
}

Rate rate_of_paths(const std::vector<Integer>& start, const GrowthMatrix& matrix,
                   const Budget& budget) {
    const std::vector<Integer> ones(matrix.size(), Integer(1));
    const Polynomial polynomial = annihilator(start, matrix, ones, budget);
    return spectral_radius(factorise(polynomial).powers, above_all(matrix));
}

Placement placed(const RecurrentSet& set, const Placement& whole, const RecurrentSet::Part& part) {
    Placement found{part.piece, normal_heading(whole.heading + part.heading, set.order()),
                    set.displacement().scaled(whole.offset)};
    set.displacement().add(found.offset, set.displacement().turned(part.offset, whole.heading));
    return found;
}

Placement seen_from(const RecurrentSet& set, const Placement& first, const Placement& other) {
    Displacement::Vector offset = other.offset;
    set.displacement().subtract(offset, first.offset);
    return {other.piece, normal_heading(other.heading - first.heading, set.order()),
            set.displacement().turned(offset, -first.heading)};
}

std::vector<RecurrentSet::Part> parts_within(const RecurrentSet& set, std::size_t piece) {
    const auto& component_of = set.components().of_letter;
    std::vector<RecurrentSet::Part> found;
    for (const RecurrentSet::Part& part : set.parts(piece))
        if (component_of[part.piece] == component_of[piece]) found.push_back(part);
    return found;
}

bool is_point(const RecurrentSet& set, const Component& component) {
    for (const std::size_t piece : component.letters)
        for (const RecurrentSet::Part& part : parts_within(set, piece))
            if (part.offset != set.displacement().zero()) return false;
    return true;
}

std::size_t Neighbours::Hash::operator()(const std::pair<std::size_t, Placement>& key) const {
    std::uint64_t hash = key.first * 0x9E3779B97F4A7C15u + key.second.piece;
    const auto mix = [&](std::uint64_t value) {
        hash = (hash ^ value) * 0xBF58476D1CE4E5B9u;
        hash ^= hash >> 29;
    };
    mix(static_cast<std::uint64_t>(key.second.heading));
    for (const std::int64_t x : key.second.offset) mix(static_cast<std::uint64_t>(x));
    return hash;
}

Neighbours::Neighbours(const RecurrentSet& set, std::size_t component, const Budget& budget,
                       std::size_t most) {
    const auto number = [&](std::size_t piece, Placement other) {
        const auto [place, is_new] = numbers_.try_emplace({piece, std::move(other)}, pairs_.size());
        if (is_new) {
            if (pairs_.size() == most)
                throw BoundReached(Bound::method, "more than " + std::to_string(most) +
                                                      " ways in which two parts may meet");
            pairs_.push_back({piece, place->first.second, {}});
            if (pairs_.size() % 1024 == 0)
                budget.check_memory(pairs_.size() * (200 + 16 * set.displacement().rank()),
                                    "the pairs of parts that meet");
        }
        return place->second;
    };
    const auto pair_of = [&](const Placement& first, const Placement& second,
                             std::vector<std::size_t>& into) {
        const Placement other = seen_from(set, first, second);
        if (may_meet(set, first.piece, other)) into.push_back(number(first.piece, other));
    };
    std::vector<std::vector<RecurrentSet::Part>> parts(set.size());
    for (const std::size_t piece : set.components().list[component].letters)
        parts[piece] = parts_within(set, piece);

    const Placement here{0, 0, set.displacement().zero()};
    const auto placed_parts = [&](Placement whole) {
        std::vector<Placement> found;
        for (const RecurrentSet::Part& part : parts[whole.piece])
            found.push_back(placed(set, whole, part));
        return found;
    };
    for (const std::size_t piece : set.components().list[component].letters) {
        const auto own = placed_parts({piece, 0, here.offset});
        for (std::size_t i = 0; i < own.size(); ++i)
            for (std::size_t j = i + 1; j < own.size(); ++j) pair_of(own[i], own[j], starts_);
    }
    WorkCount done("pairs of neighbours");
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        if (k % 256 == 0) budget.check();
        done.at(k);
        const std::size_t piece = pairs_[k].piece;
        const Placement other = pairs_[k].other;
        if (is_one_place(pairs_[k])) {  // its parts coincide too, and say nothing more
            coincide_ = true;
            pairs_[k].next = {k};
            continue;
        }
        std::vector<std::size_t> next;
        const auto first = placed_parts({piece, 0, here.offset});
        const auto second = placed_parts(other);
        for (const Placement& x : first)
            for (const Placement& y : second) pair_of(x, y, next);
        pairs_[k].next = std::move(next);
    }
    leave_out_dead_ends();
    find_critical();
}

void Neighbours::leave_out_dead_ends() {
    std::vector<std::vector<std::size_t>> before(pairs_.size());
    std::vector<std::size_t> left(pairs_.size(), 0), dead;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        left[k] = pairs_[k].next.size();
        for (const std::size_t next : pairs_[k].next) before[next].push_back(k);
        if (left[k] == 0) dead.push_back(k);
    }
    for (std::size_t i = 0; i < dead.size(); ++i)
        for (const std::size_t k : before[dead[i]])
            if (--left[k] == 0) dead.push_back(k);
    std::vector<std::size_t> renumbered(pairs_.size());
    std::vector<Pair> alive;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        renumbered[k] = alive.size();
        if (left[k] > 0) alive.push_back(std::move(pairs_[k]));
    }
    const auto renumber = [&](std::vector<std::size_t>& numbers) {
        std::vector<std::size_t> kept;
        for (const std::size_t k : numbers)
            if (left[k] > 0) kept.push_back(renumbered[k]);
        numbers = std::move(kept);
    };
    for (Pair& pair : alive) renumber(pair.next);
    renumber(starts_);
    std::erase_if(numbers_, [&](const auto& entry) { return left[entry.second] == 0; });
    for (auto& [key, value] : numbers_) value = renumbered[value];
    pairs_ = std::move(alive);
}

void Neighbours::find_critical() {
    critical_.assign(pairs_.size(), false);
    if (!coincide_) return;
    std::vector<std::vector<std::size_t>> before(pairs_.size());
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        for (const std::size_t next : pairs_[k].next) before[next].push_back(k);
        if (is_one_place(pairs_[k])) {
            critical_[k] = true;
            open.push_back(k);
        }
    }
    while (!open.empty()) {
        const std::size_t k = open.back();
        open.pop_back();
        for (const std::size_t b : before[k])
            if (!critical_[b]) {
                critical_[b] = true;
                open.push_back(b);
            }
    }
}

std::optional<std::size_t> Neighbours::find(std::size_t piece, const Placement& other) const {
    const auto place = numbers_.find({piece, other});
    if (place == numbers_.end()) return std::nullopt;
    return place->second;
}

Rate Neighbours::meeting_rate(const Budget& budget) const {
    if (pairs_.empty()) return Rate(1);
    GrowthMatrix matrix;
    for (const Pair& pair : pairs_) {
        std::map<std::size_t, Integer> counts;
        for (const std::size_t next : pair.next) counts[next] += 1;
        add_row(matrix, counts);
    }
    std::vector<Integer> start(pairs_.size());
    for (const std::size_t k : starts_) start[k] += 1;
    return rate_of_paths(start, matrix, budget);
}

namespace {

constexpr std::size_t counted_levels = 8;

/// A piece with the others that may coincide with parts of it, in order.
struct Surroundings {
    std::size_t piece;
    std::vector<Placement> others;
    bool operator<(const Surroundings& other) const {
        return piece != other.piece ? piece < other.piece : others < other.others;
    }
};

/// Every piece is told apart from those that have been seen, and its parts counted.
class Census {
public:
    Census(const RecurrentSet& set, const Neighbours& neighbours, const Budget& budget,
           std::size_t most)
        : set_(set),
          neighbours_(neighbours),
          budget_(budget),
          most_(most),
          here_{0, 0, set.displacement().zero()} {}

    std::size_t number(Surroundings surroundings) {
        const auto [place, is_new] = numbers_.try_emplace(std::move(surroundings), kinds_.size());
        if (is_new) {
            if (kinds_.size() == most_)
                throw BoundReached(Bound::method, "more than " + std::to_string(most_) +
                                                      " kinds of surroundings of parts");
            kinds_.push_back(place->first);
        }
        return place->second;
    }

    /// For each kind, the kinds of its parts and among how many they are shared.
    struct Share {
        std::size_t kind;
        long sharers;
    };
    std::vector<std::vector<Share>> all(std::size_t start_piece) {
        number({start_piece, {}});
        std::vector<std::vector<Share>> rows;
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            budget_.check();
            rows.push_back(parts_of(k));
        }
        return rows;
    }

private:
    std::vector<Share> parts_of(std::size_t kind) {
        const Surroundings whole = kinds_[kind];
        // All parts of the piece and of those around it, each with its owners; 0 is the piece.
        std::map<Placement, std::vector<std::size_t>> parts;
        const auto add = [&](const Placement& owner, std::size_t number) {
            budget_.check();
            for (const RecurrentSet::Part& part : parts_within(set_, owner.piece)) {
                auto& owners = parts[placed(set_, owner, part)];
                if (owners.empty() || owners.back() != number) owners.push_back(number);
            }
        };
        add({whole.piece, 0, here_.offset}, 0);
        for (std::size_t i = 0; i < whole.others.size(); ++i) add(whole.others[i], i + 1);
        std::vector<Share> found;
        for (const auto& [part, owners] : parts) {
            if (owners.front() != 0) continue;
            Surroundings around{part.piece, {}};
            for (const auto& [other, others_owners] : parts) {
                if (++looks_ % 1024 == 0) budget_.check();
                if (other == part) continue;
                const Placement seen = seen_from(set_, part, other);
                const Placement back = seen_from(set_, other, part);
                if (is_critical(part.piece, seen) || is_critical(other.piece, back))
                    around.others.push_back(seen);
            }
            std::sort(around.others.begin(), around.others.end());
            found.push_back({number(std::move(around)), static_cast<long>(owners.size())});
        }
        return found;
    }

    bool is_critical(std::size_t piece, const Placement& other) const {
        const auto pair = neighbours_.find(piece, other);
        return pair && neighbours_.leads_to_coincidence()[*pair];
    }

    const RecurrentSet& set_;
    const Neighbours& neighbours_;
    const Budget& budget_;
    std::size_t most_;
    Placement here_;
    std::map<Surroundings, std::size_t> numbers_;
    std::vector<Surroundings> kinds_;
    std::size_t looks_ = 0;  // at pairs of parts
};

}  // namespace

DistinctGrowth distinct_growth(const RecurrentSet& set, std::size_t component,
                               const Neighbours& neighbours, const Budget& budget,
                               std::size_t most) {
    Census census(set, neighbours, budget, most);
    const auto rows = census.all(set.components().list[component].letters.front());
    Integer scale = 1;
    for (const auto& row : rows)
        for (const auto& share : row) scale = lcm(scale, Integer(share.sharers));
    GrowthMatrix matrix;
    for (const auto& row : rows) {
        std::map<std::size_t, Integer> counts;
        for (const auto& share : row)
            counts[share.kind] += exact_divide(scale, Integer(share.sharers));
        add_row(matrix, counts);
    }
    std::vector<Integer> start(rows.size());
    start[0] = 1;
    DistinctGrowth found;
    found.kinds = rows.size();
    std::vector<Integer> level = start;
    Integer divisor = 1;
    for (std::size_t n = 0; n < counted_levels; ++n) {
        Integer sum;
        for (const Integer& count : level) sum += count;
        found.first_counts.push_back(exact_divide(sum, divisor));
        level = level * matrix;
        divisor *= scale;
    }
    // It is the rate of a sequence of integers, so an algebraic integer (Fatou).
    found.rate = quotient(rate_of_paths(start, matrix, budget), scale).value();
    return found;
}

std::optional<LimitWitness> limit_witness(const ExactDimension& found, const Budget& budget) {
    constexpr std::size_t most = 5'000;
    constexpr double slack = 1e-6;
    using Status = ExactDimension::Status;
    if (!found.limit || !found.value || !found.value->log_ratio()) return std::nullopt;
    if (found.status != Status::exact && found.status != Status::upper_bound) return std::nullopt;
    const RecurrentSet& set = *found.limit;
    const std::size_t component = multiplying_components(set).front().front();  // the fastest
    const Displacement& displacement = set.displacement();
    LimitWitness out;
    out.order = set.order();
    out.phases = set.unfolding().phases;
    out.factor = displacement.factor();
    out.component = set.components().list[component].letters.front();
    for (std::size_t i = 0; i < displacement.rank(); ++i) {
        Displacement::Vector unit = displacement.zero();
        unit[i] = 1;
        out.scale.push_back(displacement.scaled(unit));
        out.turn.push_back(displacement.turned(unit, 1));
    }
    Displacement::Vector first = displacement.zero();
    first.front() = 1;
    const std::complex<double> frame = displacement.value(first);
    double widest = 0;
    for (std::size_t p = 0; p < set.size(); ++p) widest = std::max(widest, set.disc(p).radius);
    const auto& letters = set.unfolding().letters;
    for (std::size_t p = 0; p < set.size(); ++p) {
        LimitWitness::Piece piece{letters[p % letters.size()], p / letters.size(),
                                  displacement.way(p)};
        piece.draws = !set.parts(p).empty();
        piece.disc = {set.disc(p).centre / frame,
                      (set.disc(p).radius * (1 + slack) + widest * slack) / std::abs(frame)};
        out.pieces.push_back(std::move(piece));
    }
    if (found.status == Status::upper_bound) return out;
    const auto& list = set.components().list;
    std::size_t as_fast = 0;  // even if all of their parts count, others cannot exceed the value
    for (std::size_t k = 0; k < list.size(); ++k)
        if (list[k].rate && set.is_reached(list[k].letters.front()) && !is_point(set, list[k]) &&
            !(*list[k].rate < found.value->log_ratio()->rate()))
            ++as_fast;
    try {
        const Neighbours neighbours(set, component, budget, most);
        if (neighbours.parts_coincide() && as_fast > 1) return out;
        out.neighbours.emplace();
        for (const Neighbours::Pair& pair : neighbours.pairs())
            if (!is_one_place(pair))
                out.neighbours->push_back(
                    {pair.piece, pair.other.piece, pair.other.heading, pair.other.offset});
    } catch (const BoundReached& bound) {
        if (bound.bound() == Bound::time) throw;
    }
    return out;
}

}  // namespace algae
