#include <algorithm>

#include "dimension/detail/recurrent_set.hpp"
#include "model/model.hpp"
#include "watch/watch.hpp"

// The dimension of the limit of a stochastic 0L system: a random recursive set.
//
// Where every alternative of a letter moves the turtle in the same way, parts lie where they lie whatever
// other letters become, and each is made of parts that are similar to it by the same factor |mu|. Let M
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
    for (std::size_t a = 0; a < found.size(); ++a)
        for (const auto& [word, probability] : rules.alternatives[a]) {
            if (probability == Rational(0)) continue;
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

/// The parts of each alternative of each piece.
class RandomSet {
public:
    using Choices = std::vector<std::vector<Part>>;

    /// Throws Error where alternatives move the turtle in different ways.
    RandomSet(const Together& all, const std::vector<std::vector<Alternative>>& alternatives,
              const Budget& budget)
        : set_(all.system, all.rules, budget), rules_(all.rules), alternatives_(alternatives) {
        for (std::size_t p = 0; p < set_.size(); ++p) choices_.push_back(choices_of(p));
    }

    const RecurrentSet& all() const { return set_; }
    const Choices& choices(std::size_t piece) const { return choices_[piece]; }
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
            check_way(piece, items, item, one.word.size());
            std::vector<Part>& here = found.emplace_back();
            for (std::size_t i = 0; i < one.word.size(); ++i, ++item)
                if (items[item].kind == Kind::piece && !set_.parts(items[item].piece).empty() &&
                    !parts.empty())
                    here.push_back(parts[part++]);
            item += fenced ? 1 : 0;
        }
        return found;
    }

    /// Whether these items lead where the whole leads.
    void check_way(std::size_t piece, const std::vector<Unfolding::Item>& items, std::size_t first,
                   std::size_t count) const {
        const Unfolding& unfolding = set_.unfolding();
        const Displacement& displacement = set_.displacement();
        Displacement::Vector way = displacement.zero();
        std::int64_t heading = 0;
        std::size_t depth = 0;
        for (std::size_t i = first; i < first + count; ++i) {
            if (items[i].kind == Kind::push) ++depth;
            if (items[i].kind == Kind::pop) --depth;
            if (items[i].kind != Kind::piece || depth > 0) continue;
            displacement.add(
                way, displacement.turned(displacement.way(items[i].piece), items[i].heading));
            heading = items[i].heading + unfolding.turns[items[i].piece];
        }
        if (normal_heading(heading, set_.order()) !=
                normal_heading(unfolding.turns[piece], set_.order()) ||
            way != displacement.scaled(displacement.way(piece)))
            throw Error("the alternatives of " +
                        rules_.alphabet->name(unfolding.letters[piece % unfolding.letters.size()]) +
                        " do not all end at the same place with the same heading");
    }

    RecurrentSet set_;
    const D0L& rules_;
    const std::vector<std::vector<Alternative>>& alternatives_;
    std::vector<Choices> choices_;
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
    std::map<std::pair<std::size_t, Placement>, bool> seen;
    std::vector<std::pair<std::size_t, Placement>> open;
    bool coincide = false;
    const auto meet = [&](const Placement& first, const Placement& second) {
        const Placement other = seen_from(set, first, second);
        if (!may_meet(set, first.piece, other)) return;
        coincide = coincide || other == Placement{first.piece, 0, set.displacement().zero()};
        if (!seen.try_emplace({first.piece, other}, true).second) return;
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
        const auto first = placed_parts(set.parts(piece), {piece, 0, set.displacement().zero()});
        const auto second = placed_parts(set.parts(other.piece), other);
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
    const RecurrentSet& set = random.all();
    const ExpectedParts expected = expected_parts(random);
    const Components parts = components(expected.matrix, budget);
    std::optional<std::size_t> largest;
    for (std::size_t k = 0; k < parts.list.size(); ++k) {
        const auto& rate = parts.list[k].rate;
        const std::size_t in_all = set.components().of_letter[parts.list[k].letters.front()];
        if (rate && *rate > Rate(expected.scale) && set.is_reached(parts.list[k].letters.front()) &&
            !is_point(set, set.components().list[in_all]) &&
            (!largest || *rate > *parts.list[*largest].rate))
            largest = k;
    }
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
    const std::size_t component = set.components().of_letter[parts.list[*largest].letters.front()];
    std::vector<bool> inside(set.size(), false);
    for (const std::size_t piece : set.components().list[component].letters) inside[piece] = true;
    const auto goes_on = [&](const std::vector<Part>& choice) {
        return std::ranges::any_of(choice, [&](const Part& part) { return inside[part.piece]; });
    };
    for (const std::size_t piece : set.components().list[component].letters)
        if (!std::ranges::all_of(random.choices(piece), goes_on)) {
            found.conditions.push_back("the parts that multiply the fastest may die out");
            return found;
        }
    const std::vector<bool> leads = surely(random, inside);
    if (std::ranges::none_of(set.axiom(), [&](const Part& part) { return leads[part.piece]; })) {
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
