#include <algorithm>
#include <cmath>
#include <deque>
#include <unordered_set>

#include "nature/detail/iterated_functions.hpp"
#include "watch/watch.hpp"

// Whether the parts of an attractor of similarities lie apart but for their edges: by neighbour maps.
//
// A part f_v(K_t) seen from the part f_u(K_s) is h(K_t) with h = f_u^-1 f_v. From h = f_i^-1 f_j, the
// larger one of the two is divided: f_i^-1 h, or h f_j, or both where they are equally large. Only
// maps for which h(K_t) can meet K_s are kept: discs say so. If there are finitely many and none is
// the identity between a state and itself, then a part has boundedly many others of about its size
// beside it, so the parts all count and the dimension is that of their ratios (Bandt and Graf,
// Self-similar sets 7, Proc. AMS 114, 1992: the open set condition; Das and Ngai for several
// states). If the identity is reached, two parts are one.
//
// A similarity of the plane is z -> c z + d or z -> c conj(z) + d. Its numbers are exact, in the
// field of the rational numbers and a root of unity; discs are in doubles with a margin.

namespace algae {

namespace {

using Number = CyclotomicNumber;

struct Similarity {
    Number factor, shift;
    bool reflects = false;

    bool operator==(const Similarity&) const = default;
};

/// How a part of the state `to` lies to one of the state `from`.
struct Neighbour {
    std::size_t from = 0, to = 0;
    Similarity map;

    bool operator==(const Neighbour&) const = default;
};

struct HashNeighbour {
    std::size_t operator()(const Neighbour& key) const {
        std::size_t hash = 2 * (key.from * 1'000'003 + key.to) + (key.map.reflects ? 1 : 0);
        for (const Number* number : {&key.map.factor, &key.map.shift}) {
            hash = hash * 0x9E3779B97F4A7C15u ^ hash_value(number->above);
            hash = hash * 0x9E3779B97F4A7C15u ^ hash_value(number->below);
        }
        return hash;
    }
};

/// What can be done with similarities whose numbers lie in a field.
class Similarities {
public:
    explicit Similarities(long order) : field_(order) {}

    const CyclotomicField& field() const { return field_; }

    Number linear(const Similarity& map, const Number& z) const {
        return field_.product(map.factor, map.reflects ? field_.conjugate(z) : z);
    }

    /// First `inner`, then `outer`.
    Similarity composed(const Similarity& outer, const Similarity& inner) const {
        return {linear(outer, inner.factor), field_.sum(linear(outer, inner.shift), outer.shift),
                outer.reflects != inner.reflects};
    }

    Similarity inverse(const Similarity& map) const {
        // Of z -> c conj(z) + d it is z -> conj(z / c) - conj(d / c).
        Number factor = field_.inverse(map.factor);
        Number shift = field_.difference(field_.rational(0), field_.product(factor, map.shift));
        if (map.reflects) {
            factor = field_.conjugate(factor);
            shift = field_.conjugate(shift);
        }
        return {std::move(factor), std::move(shift), map.reflects};
    }

    /// The square of the factor of distances.
    Number size(const Similarity& map) const {
        return field_.product(map.factor, field_.conjugate(map.factor));
    }

    bool is_identity(const Similarity& map) const {
        return !map.reflects && field_.is_zero(map.shift) && map.factor == field_.rational(1);
    }

    /// The map of a file, if it is written with numbers of the field.
    std::optional<Similarity> exactly(const IteratedFunctions::Map& map) const {
        Similarity found;
        const auto value = [&](std::size_t k) {
            const Quantity& number = map.numbers[k];
            return number.exact ? field_.rational(*number.exact)
                                : field_.value_of(number.expression);
        };
        const Number i = field_.zeta(field_.order() / 4);
        if (map.similarity) {
            const auto& [ratio, degrees] = *map.similarity;
            const auto size =
                ratio.exact ? field_.rational(*ratio.exact) : field_.value_of(ratio.expression);
            const auto turn = degrees.exact ? field_.direction(*degrees.exact) : std::nullopt;
            if (!size || !turn) return std::nullopt;
            found.factor = field_.product(*size, *turn);
        } else {
            const auto a = value(0), b = value(1), c = value(2), d = value(3);
            if (!a || !b || !c || !d) return std::nullopt;
            const auto negative = [&](const Number& x) {
                return field_.difference(field_.rational(0), x);
            };
            found.reflects = *d == negative(*a) && *b == *c;
            if (!found.reflects && (*d != *a || *b != negative(*c))) return std::nullopt;
            found.factor = field_.sum(*a, field_.product(i, *c));
        }
        const auto e = value(4), f = value(5);
        if (!e || !f || field_.is_zero(found.factor)) return std::nullopt;
        found.shift = field_.sum(*e, field_.product(i, *f));
        return found;
    }

private:
    CyclotomicField field_;
};

struct Disc {
    std::complex<double> centre;
    double radius = 0;
};

/// A map within the states looked at.
struct Step {
    std::size_t from, to;
    Similarity map, inverse;
    double ratio;
    std::complex<double> of_centre;
};

/// For each state a disc that its maps take the discs of others into.
void find_discs(std::vector<Disc>& discs, const std::vector<Step>& steps) {
    double farthest = 0, largest = 0;
    for (const Step& step : steps) {
        farthest = std::max(farthest, std::abs(step.of_centre - discs[step.from].centre));
        largest = std::max(largest, step.ratio);
    }
    for (Disc& disc : discs) disc.radius = farthest / (1 - largest);
    // Each round holds the sets, and is smaller.
    for (int round = 0; round < 60; ++round) {
        std::vector<double> radii(discs.size(), 0);
        for (const Step& step : steps)
            radii[step.from] =
                std::max(radii[step.from], std::abs(step.of_centre - discs[step.from].centre) +
                                               step.ratio * discs[step.to].radius);
        for (std::size_t k = 0; k < discs.size(); ++k) discs[k].radius = radii[k];
    }
}

/// The field in which all numbers of the maps lie, where there is one.
std::optional<long> common_order(std::span<const IteratedFunctions::Map> maps) {
    std::vector<const Expression*> numbers;
    std::vector<Expression> turns;  // cos degrees
    turns.reserve(maps.size());
    for (const auto& map : maps) {
        for (std::size_t k = map.similarity ? 4 : 0; k < 6; ++k)
            numbers.push_back(&map.numbers[k].expression);
        if (!map.similarity) continue;
        numbers.push_back(&map.similarity->first.expression);
        Expression turn;
        turn.kind = Expression::Kind::call;
        turn.name = "cos";
        turn.operands = {map.similarity->second.expression};
        turns.push_back(std::move(turn));
        numbers.push_back(&turns.back());
    }
    return cyclotomic_order(numbers);
}

}  // namespace

std::optional<Expression> exact_ratio(const IteratedFunctions::Map& map) {
    if (map.ratio) return map.ratio;
    const auto order = common_order(std::span(&map, 1));
    if (!order) return std::nullopt;
    const Similarities similarities(*order);
    const auto exact = similarities.exactly(map);
    if (!exact) return std::nullopt;
    Expression ratio;
    ratio.kind = Expression::Kind::call;
    ratio.name = "sqrt";
    if (const auto square = similarities.field().as_rational(similarities.size(*exact))) {
        ratio.operands = {quantity(*square).expression};
        return ratio;
    }
    Expression sum;
    sum.kind = Expression::Kind::binary;
    sum.name = "+";
    for (const std::size_t k : {std::size_t{0}, std::size_t{2}}) {
        Expression square;
        square.kind = Expression::Kind::binary;
        square.name = "*";
        square.operands = {map.numbers[k].expression, map.numbers[k].expression};
        sum.operands.push_back(std::move(square));
    }
    ratio.operands = {std::move(sum)};
    return ratio;
}

Separation separation(const IteratedFunctions& system, const std::vector<std::size_t>& states,
                      const Budget& budget, std::size_t most) {
    const auto order = common_order(system.maps);
    if (!order) return Separation::unknown;
    const Similarities similarities(*order);
    const CyclotomicField& field = similarities.field();
    std::vector<bool> inside(system.states.size());
    for (const std::size_t state : states) inside[state] = true;

    const std::vector<Box> boxes = attractor_boxes(system);
    std::vector<Disc> discs(system.states.size());
    for (const std::size_t state : states)
        discs[state].centre = {(boxes[state].low.x + boxes[state].high.x) / 2,
                               (boxes[state].low.y + boxes[state].high.y) / 2};
    std::vector<Step> steps;
    std::vector<std::vector<std::size_t>> from(system.states.size());
    for (const auto& map : system.maps) {
        if (!inside[map.from] || !inside[map.to]) continue;
        if (map.ratio && sign(enclosure(*map.ratio, 64)) == 0) continue;  // to a point
        const auto exact = similarities.exactly(map);
        if (!exact) return Separation::unknown;
        const std::complex<double> at = discs[map.to].centre;
        from[map.from].push_back(steps.size());
        steps.push_back({map.from, map.to, *exact, similarities.inverse(*exact),
                         std::abs(field.to_complex(exact->factor)),
                         field.to_complex(exact->factor) * (exact->reflects ? std::conj(at) : at) +
                             field.to_complex(exact->shift)});
    }
    find_discs(discs, steps);

    std::unordered_set<Neighbour, HashNeighbour> seen;
    std::deque<const Neighbour*> open;
    bool coincide = false;
    const auto visit = [&](Neighbour found) {
        if (found.from == found.to && similarities.is_identity(found.map)) coincide = true;
        const std::complex<double> factor = field.to_complex(found.map.factor),
                                   inner = discs[found.to].centre;
        const std::complex<double> at = factor * (found.map.reflects ? std::conj(inner) : inner) +
                                        field.to_complex(found.map.shift);
        const double reach = discs[found.from].radius + std::abs(factor) * discs[found.to].radius;
        if (std::abs(at - discs[found.from].centre) > reach * (1 + 1e-9) + 1e-12) return;
        const auto [place, is_new] = seen.insert(std::move(found));
        if (is_new) open.push_back(&*place);
    };
    for (const std::size_t state : states)
        for (const std::size_t i : from[state])
            for (const std::size_t k : from[state])
                if (i != k)
                    visit({steps[i].to, steps[k].to,
                           similarities.composed(steps[i].inverse, steps[k].map)});
    const Number one = field.rational(1);
    WorkCount neighbours("neighbours");
    while (!open.empty() && !coincide) {
        budget.check();
        neighbours.at(seen.size());
        if (seen.size() > most) return Separation::unknown;
        const Neighbour found = *open.front();
        open.pop_front();
        const auto size = field.compare(similarities.size(found.map), one);
        std::vector<Neighbour> first{found};
        if (size <= 0) {
            first.clear();
            for (const std::size_t i : from[found.from])
                first.push_back(
                    {steps[i].to, found.to, similarities.composed(steps[i].inverse, found.map)});
        }
        for (Neighbour& seen_from_part : first)
            if (size < 0)
                visit(std::move(seen_from_part));
            else
                for (const std::size_t k : from[found.to])
                    visit({seen_from_part.from, steps[k].to,
                           similarities.composed(seen_from_part.map, steps[k].map)});
    }
    return coincide ? Separation::coincide : Separation::apart;
}

}  // namespace algae
