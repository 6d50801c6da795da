#include <algorithm>
#include <set>
#include <tuple>

#include "dimension/detail/recurrent_set.hpp"
#include "model/model.hpp"
#include "watch/watch.hpp"

// The dimension of the limit of a stochastic 0L system: a random recursive set.
//
// Where every alternative of a letter moves and turns the turtle in the same way in every generation, parts lie where they
// lie whatever other letters become, and each is made of parts that are similar to it by the same factor |mu|. In the limit
// alone that would not do: what is little at first and different by chance may grow. Turns become periodic and ways obey a
// linear recurrence, so finitely many generations show it for all (Cayley and Hamilton). Let M
// be the matrix of the expected numbers of parts of each piece. Then with probability 1 the dimension of
// Hausdorff and that of boxes is log E / log |mu|, with E the spectral radius of M, if the parts that occur
// together do not overlap too much (Mauldin and Williams, Random recursive constructions: asymptotic
// geometric and topological properties, 1986; Falconer, Random fractals, 1986; Graf, Statistically self-similar
// fractals, 1987).
//
// That parts do not overlap too much is shown as in neighbours.cpp. The parts of all alternatives together are those
// of a D0L system, `a -> [w_1] ... [w_m-1] w_m`, whose recurrent set has discs for the pieces whatever is chosen. Two parts
// occur together if they come from one alternative of one piece, or from parts that occur together, by any alternatives.
// If there are finitely many ways for such pairs of discs to come together, and none of them is that of a piece with
// itself in one place, then the pieces of a level that meet a disc as large as they are number at most a constant: each
// comes together with no more than the ways, and of those that do not, the discs are disjoint. So a branching measure
// (Kesten and Stigum) of dimension log E / log |mu| lives on the set. The expected number of parts bounds
// the dimension from above in any case.

namespace algae {

namespace {

using Status = ExactDimension::Status;
using Kind = Unfolding::Item::Kind;
using Part = RecurrentSet::Part;

/// One alternative of a letter. Equal ones are one.
struct Alternative {
    Word word;
    Rational probability;
};

std::vector<std::vector<Alternative>> alternatives_of(const S0L& rules) {
    std::vector<std::vector<Alternative>> found(rules.alternatives.size());
    const auto brackets = brackets_of(*rules.alphabet);
    for (std::size_t a = 0; a < found.size(); ++a)
        for (const auto& [word, probability] : rules.alternatives[a]) {
            if (probability == Rational(0)) continue;
            if (brackets && word != Word{static_cast<Symbol>(a)} &&
                !brackets_match(word, *brackets))
                throw Error("brackets do not match within every successor");
            const auto same = std::ranges::find(found[a], word, &Alternative::word);
            if (same == found[a].end())
                found[a].push_back({word, probability});
            else
                same->probability += probability;
        }
    return found;
}

/// The system, and the D0L system of all alternatives together.
struct Together {
    Model system;
    D0L rules;
};

Together together(const Model& system, const S0L& rules,
                  const std::vector<std::vector<Alternative>>& alternatives) {
    Model all = system;
    const Symbol open = all.alphabet.symbol("["), close = all.alphabet.symbol("]");
    std::vector<Word> images;
    for (const std::vector<Alternative>& own : alternatives) {
        Word& image = images.emplace_back();
        for (const Alternative& one : own) {
            const bool is_last = &one == &own.back();
            if (!is_last) image.push_back(open);
            image.insert(image.end(), one.word.begin(), one.word.end());
            if (!is_last) image.push_back(close);
        }
    }
    while (images.size() < all.alphabet.size())
        images.push_back({static_cast<Symbol>(images.size())});
    D0L joined = make_d0l(std::make_shared<const Alphabet>(all.alphabet), rules.axiom,
                          std::move(images), rules.name);
    if (!joined.brackets) throw Error("brackets do not match within every successor");
    return {std::move(all), std::move(joined)};
}

/// Whether all alternatives of each letter lead to the same place, with the same heading, in every generation. Throws Error where they
/// do not, or where that would take too long to see.
void check_ways(const Together& all, const std::vector<std::vector<Alternative>>& alternatives,
                const Unfolding& unfolding, const Budget& budget) {
    constexpr std::uint64_t most_levels = 20'000;
    const Compass compass(all.system.drawing, 0);
    const Commands commands(all.system, all.rules.letters);
    const LatticeMotions motions(unfolding.order, false);
    const CyclotomicRing& ring = motions.ring();
    const auto brackets = *all.rules.brackets;
    struct Way {
        CyclotomicInteger move;
        std::int64_t turn = 0;
        bool operator==(const Way&) const = default;
    };
    std::vector<Way> now(all.system.alphabet.size(), Way{ring.zero()});
    for (const Symbol a : unfolding.letters) {
        const auto motion = product(motions, commands.of(a), [&](Command command) {
            return motions.of(command, compass, compass.order() / unfolding.order);
        });
        now[a] = {motion.move, motion.turn};
    }
    const auto walked = [&](const Word& word) {
        Way way{ring.zero()};
        std::vector<Way> saved;
        for (const Symbol b : word) {
            if (b == brackets.open) {
                saved.push_back(way);
            } else if (b == brackets.close) {
                way = std::move(saved.back());
                saved.pop_back();
            } else {
                ring.add_rotated(way.move, now[b].move, way.turn);
                way.turn = normal_heading(way.turn + now[b].turn, unfolding.order);
            }
        }
        return way;
    };
    const std::uint64_t dimension = unfolding.letters.size() * ring.degree();
    const std::uint64_t levels = unfolding.preperiod + unfolding.phases * (dimension + 1);
    if (levels > most_levels)
        throw Error("whether alternatives end at the same place would take " +
                    std::to_string(levels) + " generations to see, expected at most " +
                    std::to_string(most_levels));
    for (std::uint64_t level = 0; level < levels; ++level) {
        std::vector<Way> next = now;
        for (const Symbol a : unfolding.letters) {
            budget.check();
            const std::vector<Alternative>& own = alternatives[a];
            next[a] = walked(own.front().word);
            for (std::size_t i = 1; i < own.size(); ++i)
                if (walked(own[i].word) != next[a])
                    throw Error("the alternatives of " + all.system.alphabet.name(a) +
                                " do not all end at the same place with the same heading");
        }
        now = std::move(next);
    }
}

/// The parts of each alternative of each piece.
class RandomSet {
public:
    using Choices = std::vector<std::vector<Part>>;

    RandomSet(const Together& all, const std::vector<std::vector<Alternative>>& alternatives,
              const Budget& budget)
        : set_(all.system, all.rules, budget), alternatives_(alternatives) {
        for (std::size_t p = 0; p < set_.size(); ++p) {
            choices_.push_back(choices_of(p));
            auto& parts = different_.emplace_back(set_.parts(p));
            const auto key = [](const Part& part) {
                return std::tie(part.piece, part.heading, part.offset);
            };
            std::ranges::sort(parts, {}, key);
            parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
        }
    }

    const RecurrentSet& all() const { return set_; }
    const Choices& choices(std::size_t piece) const { return choices_[piece]; }
    /// The parts of all alternatives, those that several have once.
    const std::vector<Part>& different_parts(std::size_t piece) const { return different_[piece]; }
    const std::vector<Alternative>& alternatives(std::size_t piece) const {
        const auto& letters = set_.unfolding().letters;
        return alternatives_[letters[piece % letters.size()]];
    }

private:
    Choices choices_of(std::size_t piece) const {
        const Unfolding& unfolding = set_.unfolding();
        const auto& items = unfolding.items[piece];
        const auto& own = alternatives(piece);
        const std::vector<Part>& parts = set_.parts(piece);
        Choices found;
        std::size_t item = 0, part = 0;
        for (const Alternative& one : own) {
            const bool fenced = &one != &own.back();
            item += fenced ? 1 : 0;
            std::vector<Part>& here = found.emplace_back();
            for (std::size_t i = 0; i < one.word.size(); ++i, ++item)
                if (items[item].kind == Kind::piece && !set_.parts(items[item].piece).empty() &&
                    !parts.empty())
                    here.push_back(parts[part++]);
            item += fenced ? 1 : 0;
        }
        return found;
    }

    RecurrentSet set_;
    const std::vector<std::vector<Alternative>>& alternatives_;
    std::vector<Choices> choices_;
    std::vector<std::vector<Part>> different_;
};

/// The expected numbers of parts of each piece, times a whole number that makes them whole.
struct ExpectedParts {
    GrowthMatrix matrix;
    Integer scale = 1;
};

ExpectedParts expected_parts(const RandomSet& set) {
    ExpectedParts found;
    for (std::size_t p = 0; p < set.all().size(); ++p)
        for (const Alternative& one : set.alternatives(p))
            found.scale = lcm(found.scale, one.probability.denominator());
    for (std::size_t p = 0; p < set.all().size(); ++p) {
        std::map<std::size_t, Rational> counts;
        for (std::size_t i = 0; i < set.choices(p).size(); ++i)
            for (const Part& part : set.choices(p)[i])
                counts[part.piece] += set.alternatives(p)[i].probability * Rational(found.scale);
        auto& row = found.matrix.rows.emplace_back();
        for (const auto& [column, count] : counts) row.push_back({column, count.numerator()});
    }
    return found;
}

/// Whether every choice leads to a piece for which this holds, sooner or later: from pieces that hold, to those of which each
/// alternative has one that leads there.
std::vector<bool> surely(const RandomSet& set, const std::vector<bool>& holds) {
    std::vector<bool> leads = holds;
    const auto has_one = [&](const std::vector<Part>& parts) {
        return std::ranges::any_of(parts, [&](const Part& part) { return leads[part.piece]; });
    };
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t p = 0; p < leads.size(); ++p)
            if (!leads[p] && std::ranges::all_of(set.choices(p), has_one))
                leads[p] = changed = true;
    }
    return leads;
}

/// Whether every alternative of every piece of a component keeps a part in it.
bool goes_on(const RandomSet& random, std::size_t component) {
    const auto& component_of = random.all().components().of_letter;
    const auto has_one = [&](const std::vector<Part>& choice) {
        return std::ranges::any_of(
            choice, [&](const Part& part) { return component_of[part.piece] == component; });
    };
    return std::ranges::all_of(
        random.all().components().list[component].letters,
        [&](std::size_t piece) { return std::ranges::all_of(random.choices(piece), has_one); });
}

/// Whether every choice leads from the axiom into one of these components.
bool surely_reached(const RandomSet& random, const std::vector<bool>& components) {
    const RecurrentSet& set = random.all();
    std::vector<bool> inside;
    for (std::size_t p = 0; p < set.size(); ++p)
        inside.push_back(components[set.components().of_letter[p]]);
    const std::vector<bool> leads = surely(random, inside);
    return std::ranges::any_of(set.axiom(), [&](const Part& part) { return leads[part.piece]; });
}

/// How parts of a component that occur together come together: in how many ways; nothing if two may be one.
std::optional<std::size_t> ways_together(const RandomSet& random, std::size_t component,
                                         std::size_t most, const Budget& budget) {
    const RecurrentSet& set = random.all();
    const auto& component_of = set.components().of_letter;
    const auto placed_parts = [&](const std::vector<Part>& parts, const Placement& whole) {
        std::vector<Placement> found;
        for (const Part& part : parts)
            if (component_of[part.piece] == component) found.push_back(placed(set, whole, part));
        return found;
    };
    std::set<std::pair<std::size_t, Placement>> seen;
    std::vector<std::pair<std::size_t, Placement>> open;
    bool coincide = false;
    std::size_t looks = 0;
    const auto meet = [&](const Placement& first, const Placement& second) {
        if (++looks % 1024 == 0) budget.check();
        const Placement other = seen_from(set, first, second);
        if (!may_meet(set, first.piece, other)) return;
        coincide = coincide || other == Placement{first.piece, 0, set.displacement().zero()};
        if (!seen.emplace(first.piece, other).second) return;
        if (seen.size() > most)
            throw BoundReached(Bound::method, "more than " + std::to_string(most) +
                                                  " ways in which two parts may meet");
        open.emplace_back(first.piece, other);
    };
    WorkCount done("pairs of neighbours");
    for (const std::size_t piece : set.components().list[component].letters)
        for (const std::vector<Part>& choice : random.choices(piece)) {
            const auto parts = placed_parts(choice, {piece, 0, set.displacement().zero()});
            for (std::size_t i = 0; i < parts.size(); ++i)
                for (std::size_t j = i + 1; j < parts.size(); ++j) meet(parts[i], parts[j]);
        }
    for (std::size_t k = 0; k < open.size() && !coincide; ++k) {
        budget.check();
        done.at(k);
        const auto [piece, other] = open[k];
        const auto first =
            placed_parts(random.different_parts(piece), {piece, 0, set.displacement().zero()});
        const auto second = placed_parts(random.different_parts(other.piece), other);
        for (const Placement& x : first)
            for (const Placement& y : second) meet(x, y);
    }
    return coincide ? std::nullopt : std::optional(seen.size());
}

}  // namespace

ExactDimension random_dimension(const Model& system, const S0L& rules, std::size_t ways,
                                const Budget& budget) {
    const auto alternatives = alternatives_of(rules);
    const Together all = together(system, rules, alternatives);
    const RandomSet random(all, alternatives, budget);
    check_ways(all, alternatives, random.all().unfolding(), budget);
    const RecurrentSet& set = random.all();
    if (multiplying_components(set).size() > 1) throw Error(varying);
    const ExpectedParts expected = expected_parts(random);
    const Components parts = components(expected.matrix, budget);
    // Parts in one place are different ones where chance has a part in them, so points count too.
    const auto lies_in_one_place = [&](std::size_t k) {
        const auto& component_of = set.components().of_letter;
        return is_point(set, set.components().list[component_of[parts.list[k].letters.front()]]);
    };
    std::optional<std::size_t> largest;
    for (std::size_t k = 0; k < parts.list.size(); ++k) {
        const auto& rate = parts.list[k].rate;
        if (!rate || !(*rate > Rate(expected.scale)) ||
            !set.is_reached(parts.list[k].letters.front()))
            continue;
        const auto order =
            largest ? *rate <=> *parts.list[*largest].rate : std::strong_ordering::greater;
        if (order > 0 || (order == 0 && lies_in_one_place(*largest))) largest = k;
    }
    // Whatever is chosen, something that is as large as the whole must be drawn for ever: else the whole is smaller.
    const std::vector<Component>& list = set.components().list;
    std::vector<bool> lasting;
    for (std::size_t k = 0; k < list.size(); ++k)
        lasting.push_back(list[k].rate && !is_point(set, list[k]) && goes_on(random, k));
    if (!surely_reached(random, lasting))
        throw Error("by some choices nothing that is drawn is as large as the whole");
    if (!largest) throw Error("no parts that are drawn multiply on average");

    ExactDimension found;
    found.almost_surely = true;
    found.status = Status::upper_bound;
    const ExpectedRatio formula(*parts.list[*largest].rate, expected.scale,
                                ScalingRatio(set.displacement()));
    found.value = found.similarity = formula;
    found.conditions.push_back("all parts become similar, smaller by the factor " +
                               formula.ratio().text() + " in each generation, whatever is chosen");
    found.conditions.push_back("on average parts multiply by " + formula.average());
    if (ways == 0) {
        found.conditions.push_back("whether parts coincide has not been looked at");
        return found;
    }
    if (lies_in_one_place(*largest)) {
        found.conditions.push_back("the parts that multiply the fastest lie in one place");
        return found;
    }
    const std::size_t component = set.components().of_letter[parts.list[*largest].letters.front()];
    if (!goes_on(random, component)) {
        found.conditions.push_back("the parts that multiply the fastest may die out");
        return found;
    }
    std::vector<bool> fastest(list.size(), false);
    fastest[component] = true;
    if (!surely_reached(random, fastest)) {
        found.conditions.push_back("by some choices there are no parts that multiply as fast");
        return found;
    }
    try {
        const auto together = ways_together(random, component, ways, budget);
        if (!together) {
            found.conditions.push_back("parts may coincide, so it is an upper bound");
            return found;
        }
        found.status = Status::exact;
        found.conditions.push_back(
            "parts meet in at most " + counted(*together, "way") +
            ", whatever is chosen; no two coincide, so with probability 1 all of them count");
    } catch (const BoundReached& bound) {
        if (bound.bound() == Bound::time) throw;
        found.conditions.push_back(std::string("whether parts coincide is not known: ") +
                                   bound.what());
    }
    return found;
}

}  // namespace algae
