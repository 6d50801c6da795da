#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "model/model.hpp"

#include "dimension/detail/recurrent_set.hpp"

// From a system to the set that its curves approach.
//
// A letter a becomes h^k(a), which moves a turtle and turns it. The turn of h^k(a) follows from the
// turns of the letters of h(a) at level k - 1, so the turns of all letters at one level determine
// those of the next: the sequence of these vectors becomes periodic. A piece is a letter in a phase
// of the period; with so many phases, each piece consists of pieces of the phase before at fixed
// headings (`unfolding`). Brackets must match in every successor, so that branches are parts that
// begin where they are opened and do not move the turtle on.
//
// The ways of the pieces grow by one factor mu (`Displacement`, displacement.cpp). Where several
// factors of equal size work, more phases may separate them, as those that differ by a root of
// unity become one: the recurrent set is made with the fewest phases for which there is one factor.
//
// A piece belongs to the limit only if it leads to drawing at every later level. For the pieces
// that do,
//
//     mu K_a = union over the parts of a of zeta^heading K_part + offset,
//
// which has one solution of compact sets (Dekking, Recurrent sets, 1982; Mauldin and Williams
// 1988). Offsets are exact. Discs around the pieces are found in doubles with a margin: first one
// around the beginning that is large enough for all, then repeatedly discs around the discs of the
// parts. They decide which parts may meet, never that two coincide; that they hold their pieces is proved.

namespace algae {

namespace {

using Kind = Unfolding::Item::Kind;

constexpr std::size_t most_levels = 10'000;

/// Why directions are not exact.
std::string inexact(const Drawing& drawing) {
    const auto& angle = drawing.angle;
    const std::string is_no = " no rational part of a turn with a denominator up to 360";
    if (angle && !(angle->exact && (*angle->exact / Rational(360)).denominator() <= 360))
        return "the angle " + to_text(angle->expression) + " is" + is_no;
    return "the start's heading, together with the angle, is" + is_no;
}

/// Reads a system's letters as commands of a turtle with exact turns.
class Reader {
public:
    Reader(const Model& system, const D0L& rules)
        : rules_(rules),
          compass_(system.drawing, 0),
          commands_(system, rules.letters),
          place_(system.alphabet.size(), none) {
        if (!compass_.is_exact()) throw Error(inexact(system.drawing));
        if (commands_.uses(Command::scale)) throw Error("the symbol * changes the turtle's step");
        if (commands_.uses(Command::cut)) throw Error("the symbol % leaves branches out");
        for (const Symbol a : rules.letters)
            if (!is_bracket(a)) {
                place_[a] = letters.size();
                letters.push_back(a);
                check_brackets(a);
                most_corners_.push_back(most_corners(a));
            }
        reduce_order();
    }

    static constexpr std::size_t none = ~std::size_t{0};

    bool is_bracket(Symbol a) const {
        const auto& brackets = rules_.brackets;
        return brackets && (a == brackets->open || a == brackets->close);
    }
    bool opens(Symbol a) const { return a == rules_.brackets->open; }
    std::size_t place(Symbol a) const { return place_[a]; }
    std::int64_t order() const { return order_; }

    /// What the letter itself does.
    LatticeMotions::value_type motion(const LatticeMotions& motions, Symbol a) const {
        return product(motions, commands_.of(a),
                       [&](Command command) { return motions.of(command, compass_, unit_); });
    }

    /// Whether the letter leaves something that is seen: a step with the pen down or a polygon of its own.
    bool draws(const LatticeMotions::value_type& motion, Symbol a) const {
        return !motion.segments.is_zero() || most_corners_[place_[a]] > 2;
    }

    std::vector<Symbol> letters;

private:
    /// The most corners of a polygon that the letter fills. The sides of one from letter to letter are as long as the figure, and no
    /// piece has them.
    std::size_t most_corners(Symbol a) const {
        const char* beyond = "a polygon goes on from letter to letter";
        std::vector<std::size_t> open;
        std::size_t most = 0;
        for (const Command command : commands_.of(a)) {
            if (command == Command::close_polygon) {
                if (open.empty()) throw Error(beyond);
                most = std::max(most, open.back());
                open.pop_back();
            }
            if (command == Command::open_polygon) open.push_back(0);
            const bool is_corner = command == Command::open_polygon || command == Command::draw ||
                                   command == Command::move || command == Command::vertex;
            if (is_corner && !open.empty()) ++open.back();
        }
        if (!open.empty()) throw Error(beyond);
        return most;
    }
    void check_brackets(Symbol a) const {
        std::size_t depth = 0;
        for (const Command command : commands_.of(a)) {
            if (command == Command::push) ++depth;
            if (command == Command::pop && depth-- == 0)
                throw Error("brackets do not match within every successor");
        }
        if (depth != 0) throw Error("brackets do not match within every successor");
    }

    /// Directions that no turn leads to are left out.
    void reduce_order() {
        std::int64_t common = compass_.order();
        if (commands_.uses(Command::left) || commands_.uses(Command::right))
            common = std::gcd(common, compass_.turn());
        if (commands_.uses(Command::back)) common = std::gcd(common, compass_.half());
        unit_ = common;
        order_ = compass_.order() / common;
    }

    const D0L& rules_;
    Compass compass_;
    Commands commands_;
    std::vector<std::size_t> place_;
    std::vector<std::size_t> most_corners_;  // by letter
    std::int64_t unit_ = 1, order_ = 1;
};

/// The items of h(a) where the letters of the level below turn by `turns`, and what h(a) turns by.
std::pair<std::vector<Unfolding::Item>, std::int64_t> items(const Reader& reader,
                                                            const Word& successor,
                                                            const std::vector<std::int64_t>& turns,
                                                            std::size_t first_piece) {
    std::vector<Unfolding::Item> found;
    std::vector<std::int64_t> saved;
    std::int64_t heading = 0;
    for (const Symbol b : successor) {
        if (reader.is_bracket(b)) {
            const bool opens = reader.opens(b);
            found.push_back({opens ? Kind::push : Kind::pop, 0, 0});
            if (opens) {
                saved.push_back(heading);
            } else {
                heading = saved.back();
                saved.pop_back();
            }
            continue;
        }
        found.push_back({Kind::piece, first_piece + reader.place(b), heading});
        heading = normal_heading(heading + turns[reader.place(b)], reader.order());
    }
    return {std::move(found), heading};
}

/// The pieces outside branches, which lead from the beginning to the end.
std::vector<Unfolding::Item> path(const std::vector<Unfolding::Item>& items) {
    std::vector<Unfolding::Item> found;
    std::size_t depth = 0;
    for (const Unfolding::Item& item : items) {
        if (item.kind == Kind::push) ++depth;
        if (item.kind == Kind::pop) --depth;
        if (item.kind == Kind::piece && depth == 0) found.push_back(item);
    }
    return found;
}

/// The ways of one level from those of the level below, where letters turn by `turns`.
std::vector<CyclotomicInteger> next_ways(const Reader& reader, const D0L& rules,
                                         const CyclotomicRing& ring,
                                         const std::vector<std::int64_t>& turns,
                                         const std::vector<CyclotomicInteger>& ways) {
    std::vector<CyclotomicInteger> next;
    for (const Symbol a : reader.letters) {
        CyclotomicInteger& here = next.emplace_back(ring.zero());
        for (const auto& item : path(items(reader, rules.successor(a), turns, 0).first))
            ring.add_rotated(here, ways[item.piece], item.heading);
    }
    return next;
}

}  // namespace

std::vector<bool> lasting(const std::vector<std::vector<std::size_t>>& parts,
                          const std::vector<bool>& holds) {
    std::vector<bool> kept = holds;
    const auto any_part = [&](std::size_t p) {
        return std::any_of(parts[p].begin(), parts[p].end(),
                           [&](std::size_t part) { return kept[part]; });
    };
    // Those that lead to one for which it holds; of these, what has no part among them is left out.
    for (const bool leads : {true, false})
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t p = 0; p < parts.size(); ++p)
                if (kept[p] != leads && any_part(p) == leads) {
                    kept[p] = leads;
                    changed = true;
                }
        }
    return kept;
}

std::vector<bool> drawing_in_all(const std::vector<std::vector<std::size_t>>& parts,
                                 std::vector<bool> draws) {
    std::set<std::vector<bool>> seen;
    while (seen.size() < most_levels) {
        std::vector<bool> next;
        for (const auto& own : parts)
            next.push_back(std::ranges::any_of(own, [&](std::size_t part) { return draws[part]; }));
        if (next == draws) return draws;
        if (!seen.insert(next).second)
            throw Error("what draws in some late generations does not in others");
        draws = std::move(next);
    }
    throw BoundReached(Bound::method, "what draws does not settle within " +
                                          std::to_string(most_levels) + " generations");
}

std::int64_t normal_heading(std::int64_t heading, std::int64_t order) {
    heading %= order;
    return heading < 0 ? heading + order : heading;
}

Unfolding unfolding(const Model& system, const D0L& rules, std::size_t phase_factor) {
    const Reader reader(system, rules);
    const std::size_t count = reader.letters.size();
    const LatticeMotions motions(reader.order(), false);
    const CyclotomicRing& ring = motions.ring();

    // The turns of each level until they come back, and the ways of the first of them.
    std::vector<std::int64_t> turns;
    std::vector<CyclotomicInteger> moves;
    std::vector<bool> draws;
    for (const Symbol a : reader.letters) {
        const auto motion = reader.motion(motions, a);
        turns.push_back(motion.turn);
        moves.push_back(motion.move);
        draws.push_back(reader.draws(motion, a));
    }
    std::map<std::vector<std::int64_t>, std::size_t> seen;
    std::vector<std::vector<std::int64_t>> levels;
    while (seen.emplace(turns, levels.size()).second) {
        if (levels.size() == most_levels)
            throw BoundReached(Bound::method, "turns do not come back within " +
                                                  std::to_string(most_levels) + " generations");
        levels.push_back(turns);
        for (std::size_t a = 0; a < count; ++a)
            turns[a] = items(reader, rules.successor(reader.letters[a]), levels.back(), 0).second;
    }

    Unfolding out;
    out.order = reader.order();
    out.letters = reader.letters;
    out.preperiod = seen.at(turns);
    const std::size_t period = levels.size() - seen.at(turns);
    out.phases = period * phase_factor;
    for (std::size_t level = 0; level < out.preperiod; ++level)
        moves = next_ways(reader, rules, ring, levels[level], moves);
    for (std::size_t phase = 0; phase < out.phases; ++phase) {
        const std::size_t before = (phase + out.phases - 1) % out.phases;
        const auto& below = levels[out.preperiod + before % period];
        const auto& own = levels[out.preperiod + phase % period];
        if (phase > 0) moves = next_ways(reader, rules, ring, below, moves);
        for (std::size_t a = 0; a < count; ++a) {
            out.items.push_back(
                items(reader, rules.successor(reader.letters[a]), below, before * count).first);
            out.paths.push_back(path(out.items.back()));
            out.turns.push_back(own[a]);
            out.moves.push_back(moves[a]);
            out.draws.push_back(draws[a]);
        }
    }
    out.axiom = items(reader, rules.axiom, levels[out.preperiod], 0).first;
    return out;
}

namespace {

/// The unfolding with as few phases as part the scaling factors, and its displacement.
std::pair<Unfolding, Displacement> unfolded(const Model& system, const D0L& rules,
                                            const Budget& budget) {
    for (const std::size_t factor : {1u, 2u, 3u, 4u, 5u, 6u, 8u, 10u, 12u}) {
        Unfolding found = unfolding(system, rules, factor);
        try {
            Displacement displacement(found, budget);
            return {std::move(found), std::move(displacement)};
        } catch (const EqualFactors&) {
            if (factor == 12) throw;
        }
    }
    throw EqualFactors("several scaling factors are equally large");
}

/// The pieces that lead to drawing at every later level, which does not depend on their phase.
std::vector<bool> drawing_for_ever(const Unfolding& unfolding) {
    const std::size_t count = unfolding.letters.size();
    std::vector<std::vector<std::size_t>> parts(count);
    for (std::size_t a = 0; a < count; ++a)
        for (const Unfolding::Item& item : unfolding.items[a])
            if (item.kind == Kind::piece) parts[a].push_back(item.piece % count);
    const std::vector<bool> draws(unfolding.draws.begin(),
                                  unfolding.draws.begin() + static_cast<std::ptrdiff_t>(count));
    const std::vector<bool> found = drawing_in_all(parts, draws);
    std::vector<bool> all;
    for (std::size_t p = 0; p < unfolding.size(); ++p) all.push_back(found[p % count]);
    return all;
}

/// Those pieces that these lead to.
std::vector<bool> reached_from(const RecurrentSet& set, std::vector<std::size_t> open) {
    std::vector<bool> reached(set.size(), false);
    for (const std::size_t p : open) reached[p] = true;
    while (!open.empty()) {
        const std::size_t p = open.back();
        open.pop_back();
        for (const RecurrentSet::Part& part : set.parts(p)) {
            if (reached[part.piece]) continue;
            reached[part.piece] = true;
            open.push_back(part.piece);
        }
    }
    return reached;
}

}  // namespace

std::vector<std::vector<std::size_t>> multiplying_components(const RecurrentSet& set) {
    const Unfolding& unfolding = set.unfolding();
    const auto& list = set.components().list;
    std::vector<std::vector<std::size_t>> found;
    for (std::size_t phase = 0; phase < unfolding.phases; ++phase) {
        std::vector<std::size_t> begin;
        for (const Unfolding::Item& item : unfolding.axiom) {
            const std::size_t piece = phase * unfolding.letters.size() + item.piece;
            if (item.kind == Kind::piece && !set.parts(piece).empty()) begin.push_back(piece);
        }
        const std::vector<bool> reached = reached_from(set, std::move(begin));
        std::vector<std::size_t> own;
        for (std::size_t k = 0; k < list.size(); ++k)
            if (list[k].rate && *list[k].rate > Rate(1) && reached[list[k].letters.front()] &&
                !is_point(set, list[k]))
                own.push_back(k);
        std::ranges::stable_sort(
            own, [&](std::size_t a, std::size_t b) { return *list[a].rate > *list[b].rate; });
        if (std::ranges::find(found, own) == found.end()) found.push_back(std::move(own));
    }
    if (std::ranges::any_of(found, [](const auto& own) { return own.empty(); }))
        throw Error(found.size() == 1 ? vanishing : varying);
    return found;
}

RecurrentSet::Disc around(const std::vector<RecurrentSet::Disc>& discs) {
    double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
    for (const auto& [centre, radius] : discs) {
        left = std::min(left, centre.real() - radius);
        right = std::max(right, centre.real() + radius);
        low = std::min(low, centre.imag() - radius);
        high = std::max(high, centre.imag() + radius);
    }
    RecurrentSet::Disc found{{(left + right) / 2, (low + high) / 2}, 0};
    for (const auto& [centre, radius] : discs)
        found.radius = std::max(found.radius, std::abs(centre - found.centre) + radius);
    return found;
}

RecurrentSet::RecurrentSet(const Model& system, const D0L& rules, const Budget& budget)
    : RecurrentSet(unfolded(system, rules, budget), budget) {}

RecurrentSet::RecurrentSet(std::pair<Unfolding, Displacement> parts, const Budget& budget)
    : unfolding_(std::move(parts.first)), displacement_(std::move(parts.second)) {
    const std::vector<bool> lasting = drawing_for_ever(unfolding_);
    for (std::size_t p = 0; p < unfolding_.size(); ++p)
        parts_.push_back(lasting[p] ? walked(unfolding_.items[p], lasting) : std::vector<Part>());
    axiom_ = walked(unfolding_.axiom, lasting);
    if (axiom_.empty()) throw Error("nothing is drawn in late generations");

    GrowthMatrix matrix;
    for (const auto& own : parts_) {
        std::vector<Integer> counts(parts_.size());
        for (const Part& part : own) counts[part.piece] += 1;
        auto& row = matrix.rows.emplace_back();
        for (std::size_t q = 0; q < counts.size(); ++q)
            if (!counts[q].is_zero()) row.push_back({q, counts[q]});
    }
    components_ = algae::components(matrix, budget);
    for (std::int64_t heading = 0; heading < order(); ++heading) {
        const Rational part(2 * heading, order());
        directions_.emplace_back(cos_pi(part, 96).midpoint(), sin_pi(part, 96).midpoint());
    }
    find_reached();
    find_discs();
}

/// The parts among items that last, with their offsets.
std::vector<RecurrentSet::Part> RecurrentSet::walked(const std::vector<Unfolding::Item>& items,
                                                     const std::vector<bool>& lasting) const {
    std::vector<Part> found;
    std::vector<Displacement::Vector> saved;
    Displacement::Vector here = displacement_.zero();
    for (const Unfolding::Item& item : items) {
        if (item.kind == Kind::push) {
            saved.push_back(here);
        } else if (item.kind == Kind::pop) {
            here = std::move(saved.back());
            saved.pop_back();
        } else {
            if (lasting[item.piece]) found.push_back({item.piece, item.heading, here});
            displacement_.add(here,
                              displacement_.turned(displacement_.way(item.piece), item.heading));
        }
    }
    return found;
}

void RecurrentSet::find_reached() {
    std::vector<std::size_t> begin;
    for (const Part& part : axiom_) begin.push_back(part.piece);
    reached_ = reached_from(*this, begin);
}

std::complex<double> RecurrentSet::direction(std::int64_t heading) const {
    return directions_[static_cast<std::size_t>(normal_heading(heading, order()))];
}

/// From discs around the beginnings that are large enough, towards smaller ones: a disc around the
/// discs of a piece's parts holds the piece if theirs hold them. The last ones are made wider until `hold` says so.
void RecurrentSet::find_discs() {
    const double ratio = displacement_.ratio();
    double farthest = 0;
    for (const auto& own : parts_)
        for (const Part& part : own)
            farthest = std::max(farthest, std::abs(displacement_.value(part.offset)));
    discs_.assign(size(), {0, farthest / (ratio - 1) * (1 + 1e-9) + 1e-12});
    constexpr int rounds = 60;
    for (int round = 0; round < rounds; ++round) {
        std::vector<Disc> next = discs_;
        for (std::size_t p = 0; p < size(); ++p) {
            std::vector<Disc> discs;
            for (const Part& part : parts_[p])
                discs.push_back({(direction(part.heading) * discs_[part.piece].centre +
                                  displacement_.value(part.offset)) /
                                     displacement_.factor(),
                                 discs_[part.piece].radius / ratio});
            if (discs.empty()) continue;
            const Disc tighter = around(discs);
            if (tighter.radius < discs_[p].radius) next[p] = tighter;
        }
        discs_ = std::move(next);
    }
    for (double wider = 1e-9; wider < 10; wider *= 10) {
        std::vector<Disc> found = discs_;
        for (Disc& disc : found) disc.radius = disc.radius * (1 + wider) + wider;
        if (!hold(found)) continue;
        discs_ = std::move(found);
        return;
    }
    throw BoundReached(Bound::digits, "the lattice of positions needs too many digits");
}

/// Whether the discs of all parts lie in those of their pieces, which proves that the pieces lie in
/// their discs: the maps of a graph-directed set take such discs into themselves, so the sets that
/// they tend to lie in them. Every number here has an error of at most u = 2^-53 of its own size and some of those
/// that it is made of, fewer than 2^5 in all, beside that of the offset; 2^-46 times the sum of all sizes is more.
bool RecurrentSet::hold(const std::vector<Disc>& discs) const {
    constexpr double rounding = 0x1p-46;
    const double ratio = displacement_.ratio();
    for (std::size_t p = 0; p < size(); ++p)
        for (const Part& part : parts_[p]) {
            const Disc &whole = discs[p], &inner = discs[part.piece];
            const std::complex<double> offset = displacement_.value(part.offset);
            const double apart = std::abs(direction(part.heading) * inner.centre + offset -
                                          displacement_.factor() * whole.centre);
            const double sizes = std::abs(inner.centre) + std::abs(offset) + inner.radius +
                                 ratio * (std::abs(whole.centre) + whole.radius);
            if (!(apart + inner.radius + displacement_.error(part.offset) + rounding * sizes <=
                  ratio * whole.radius))
                return false;
        }
    return true;
}

}  // namespace algae
