#include "dimension/unfolding.hpp"

#include <map>
#include <numeric>

#include "base/error.hpp"
#include "turtle/command_product.hpp"
#include "turtle/compass.hpp"
#include "turtle/lattice_motions.hpp"

namespace algae {

namespace {

constexpr std::size_t most_levels = 10'000;

/// Why directions are not exact.
std::string inexact(const Settings& settings) {
    const auto& angle = settings.angle;
    const std::string is_no = " no rational part of a turn with a denominator up to 360";
    if (angle && !(angle->exact && (*angle->exact / Rational(360)).denominator() <= 360))
        return "the angle " + to_text(angle->expression) + " is" + is_no;
    return "the start's heading, together with the angle, is" + is_no;
}

/// Reads a system's letters as commands of a turtle with exact turns.
class Reader {
public:
    Reader(const LSystem& system, const D0L& rules)
        : rules_(rules),
          compass_(system.settings, 0),
          commands_(system, rules.letters),
          place_(system.alphabet.size(), none) {
        if (!compass_.is_exact()) throw Error(inexact(system.settings));
        if (commands_.uses(Command::scale)) throw Error("the symbol * changes the turtle's step");
        if (commands_.uses(Command::cut)) throw Error("the symbol % leaves branches out");
        for (const Symbol a : rules.letters)
            if (!is_bracket(a)) {
                place_[a] = letters.size();
                letters.push_back(a);
                check_brackets(a);
            }
        reduce_order();
    }

    static constexpr std::size_t none = ~std::size_t{0};

    bool is_bracket(Symbol a) const {
        const auto& brackets = rules_.rules.brackets;
        return brackets && (a == brackets->open || a == brackets->close);
    }
    bool opens(Symbol a) const { return a == rules_.rules.brackets->open; }
    std::size_t place(Symbol a) const { return place_[a]; }
    std::int64_t order() const { return order_; }

    /// What the letter itself does.
    LatticeMotions::value_type motion(const LatticeMotions& motions, Symbol a) const {
        return product(motions, commands_.of(a), [&](Command command) {
            switch (command) {
                case Command::draw:
                case Command::draw_unmarked:
                    return motions.step(true);
                case Command::move:
                    return motions.step(false);
                case Command::left:
                    return motions.turned(compass_.turn() / unit_);
                case Command::right:
                    return motions.turned(-compass_.turn() / unit_);
                case Command::back:
                    return motions.turned(compass_.half() / unit_);
                default:
                    return motions.one();
            }
        });
    }

    std::vector<Symbol> letters;

private:
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
    std::int64_t unit_ = 1, order_ = 1;
};

/// The items of h(a) where the letters of the level below turn by `turns`, and what h(a) turns by.
std::pair<std::vector<Unfolding::Item>, std::int64_t> items(const Reader& reader,
                                                            const Word& successor,
                                                            const std::vector<std::int64_t>& turns,
                                                            std::size_t first_piece) {
    using Kind = Unfolding::Item::Kind;
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
    using Kind = Unfolding::Item::Kind;
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

std::int64_t normal_heading(std::int64_t heading, std::int64_t order) {
    heading %= order;
    return heading < 0 ? heading + order : heading;
}

Unfolding unfolding(const LSystem& system, const D0L& rules, std::size_t phase_factor) {
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
        draws.push_back(!motion.segments.is_zero());
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

}  // namespace algae
