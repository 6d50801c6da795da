#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "model/model.hpp"

#include "nature/detail/iterated_functions.hpp"

// What is known exactly of iterated function systems: their similarity dimension, and which of them
// the curves of an L-system approach.
//
// If all maps are similarities, the s for which the sum of ratio^s is 1 (Moran 1946), with several
// states the matrix of these sums has the spectral radius 1 (Mauldin and Williams 1988), is an
// upper bound of the dimension of the attractor, and equal to it where the open set condition
// holds, which `separation` proves by neighbour maps. Each strongly connected component of states that is reached
// has its own s; the largest counts. Where all ratios are one over the square root of the same
// natural number, the value is written as log rate / log ratio.
//
// Maps that take a rectangle to cells of a grid are no similarities; the dimensions of their attractor, a carpet, are
// known in another way (`CarpetDimension`).
//
// The curves of a D0L system approach a recurrent set (Dekking 1982), which is the attractor of a
// graph-directed system: a state for each piece, and a map of the ratio 1/|mu| for each part of it,
// with the heading of the part less the argument of mu as its turn. Ratios are written exactly
// where |mu|^2 is a whole number; offsets with square roots where these are recognised, so that a
// lattice remains one; other offsets and turns are decimals.

namespace algae {

namespace {

using Status = ExactDimension::Status;
using Entry = RatioSum::Entry;

/// The square of a ratio, where that is a rational number.
std::optional<Rational> rational_square(const Expression& ratio) {
    const auto order = cyclotomic_order({&ratio});
    if (!order) return std::nullopt;
    const CyclotomicField field(*order);
    const auto value = field.value_of(shortened(ratio));
    return value ? field.as_rational(field.product(*value, *value)) : std::nullopt;
}

/// log rate / log ratio, where all ratios are the same and one over the root of a natural number.
std::optional<LogRatio> equal_ratios(const std::vector<Entry>& entries, const Rate& rate) {
    std::optional<Rational> common;
    for (const Entry& entry : entries) {
        const auto square = rational_square(entry.ratio);
        if (!square || square->is_zero() || (common && *common != *square)) return std::nullopt;
        common = square;
    }
    const Rational inverse = Rational(1) / *common;
    if (!inverse.is_integer()) return std::nullopt;
    return LogRatio(rate, ScalingRatio::square_root(inverse.numerator()));
}

}  // namespace

ExactDimension similarity_dimension(const IteratedFunctions& system, const Budget& budget) {
    ExactDimension found;
    std::vector<Expression> ratios;
    for (const auto& map : system.maps) {
        const auto ratio = exact_ratio(map);
        if (!ratio) {
            found.conditions.push_back(map.name + " is no similarity");
            return found;
        }
        ratios.push_back(*ratio);
    }
    std::vector<bool> is_reached = reachable(system).front();
    is_reached.front() = true;
    std::vector<Entry> entries;
    for (std::size_t k = 0; k < ratios.size(); ++k)  // maps to points add countably many points
        if (sign(enclosure(ratios[k], 64)) != 0)
            entries.push_back({system.maps[k].from, system.maps[k].to, ratios[k]});
    const Components all = RatioSum::components(system.states.size(), entries, budget);
    std::optional<double> largest;
    std::vector<std::size_t> states;
    for (const Component& component : all.list) {
        if (!component.rate || !is_reached[component.letters.front()]) continue;
        std::vector<Entry> own = RatioSum::within(component, entries);
        const bool single = *component.rate == Rate(1);
        DimensionFormula formula = LogRatio(Rate(1), ScalingRatio(Integer(2)));
        if (const auto log_ratio = equal_ratios(own, *component.rate))
            formula = *log_ratio;
        else if (!single)
            formula = RatioSum(component.letters.size(), std::move(own));
        const double value = formula.enclosure(64).midpoint();
        if (largest && value <= *largest) continue;
        largest = value;
        found.value = found.similarity = formula;
        states = component.letters;
    }
    if (!largest) {
        found.conditions.push_back("a map takes everything to one point");
        return found;
    }
    found.status = Status::upper_bound;
    found.conditions.push_back("all maps are similarities");
    const Separation parts = separation(system, states, budget);
    if (parts == Separation::apart) {
        found.status = Status::exact;
        found.conditions.push_back(
            "parts meet in finitely many ways and no two coincide, so the open set condition "
            "holds");
    } else if (parts == Separation::coincide) {
        found.conditions.push_back(all.list.size() == 1
                                       ? "two parts coincide, so the dimension is smaller"
                                       : "two parts coincide, so it is an upper bound");
    } else {
        found.conditions.push_back("an upper bound unless the open set condition holds");
    }
    return found;
}

namespace {

/// At which of so many equal places of some interval numbers stand, counted from the first that is used.
std::optional<std::vector<long>> places_in_grid(const std::vector<Rational>& numbers, long cells) {
    const Rational least = *std::min_element(numbers.begin(), numbers.end());
    Rational step = 0;  // what all of them are multiples of, by Euclid's algorithm
    for (const Rational& number : numbers)
        for (Rational rest = number - least; !rest.is_zero();) {
            if (step.is_zero())
                std::swap(step, rest);
            else {
                const Rational left = step - Rational(floor(step / rest)) * rest;
                step = rest;
                rest = left;
            }
        }
    std::vector<long> places;
    for (const Rational& number : numbers) {
        const Rational place = step.is_zero() ? Rational(0) : (number - least) / step;
        if (!(place < Rational(cells))) return std::nullopt;
        places.push_back(place.numerator().to_int64());
    }
    return places;
}

/// k of a number that is 1/k for some k from 2 on, not too large.
std::optional<long> reciprocal(const Quantity& of) {
    constexpr long largest = 1'000'000;
    if (!of.exact || !(Rational(0) < *of.exact)) return std::nullopt;
    const Rational found = Rational(1) / *of.exact;
    if (!found.is_integer() || found < Rational(2) || Rational(largest) < found)
        return std::nullopt;
    return found.numerator().to_int64();
}

}  // namespace

std::optional<ExactDimension> carpet_dimension(const IteratedFunctions& system) {
    if (system.states.size() != 1 || system.maps.empty() || system.maps[0].similarity)
        return std::nullopt;
    const auto& first = system.maps[0].numbers;  // a b c d e f
    const auto across = reciprocal(first[0]), upward = reciprocal(first[3]);
    if (!across || !upward || *across == *upward) return std::nullopt;
    std::vector<Rational> x, y;
    for (const auto& map : system.maps) {
        if (map.similarity) return std::nullopt;
        for (const std::size_t k : {std::size_t{1}, std::size_t{2}})
            if (!map.numbers[k].exact || !map.numbers[k].exact->is_zero()) return std::nullopt;
        if (map.numbers[0].exact != first[0].exact || map.numbers[3].exact != first[3].exact ||
            !map.numbers[4].exact || !map.numbers[5].exact)
            return std::nullopt;
        x.push_back(*map.numbers[4].exact);
        y.push_back(*map.numbers[5].exact);
    }
    auto line = places_in_grid(x, *across), cell = places_in_grid(y, *upward);
    if (!line || !cell) return std::nullopt;
    if (*across > *upward) std::swap(line, cell);
    const long m = std::min(*across, *upward), n = std::max(*across, *upward);
    std::map<long, std::set<long>> kept;
    for (std::size_t k = 0; k < line->size(); ++k) kept[(*line)[k]].insert((*cell)[k]);
    std::vector<long> lines;
    for (const auto& [place, cells] : kept) lines.push_back(static_cast<long>(cells.size()));
    using Kind = CarpetDimension::Kind;
    const auto formula = [&](Kind kind) { return CarpetDimension(kind, m, n, lines); };
    ExactDimension found;
    found.status = Status::exact;
    found.value = formula(Kind::hausdorff);
    const auto [least, most] = std::minmax_element(lines.begin(), lines.end());
    found.is_regular = *least == *most;
    if (!found.is_regular)
        found.others = {formula(Kind::box), formula(Kind::assouad), formula(Kind::lower),
                        "infinite"};
    found.conditions.push_back(
        "a self-affine carpet: the maps take a rectangle to cells of a grid of " +
        std::to_string(*across) + " by " + std::to_string(*upward));
    return found;
}

namespace {

/// The decimal that is this double; what is nothing but rounding beside 1 is 0 or whole.
Quantity decimal(double value) {
    const double whole = std::round(value);
    if (std::fabs(value - whole) < 1e-13) return quantity(Rational(static_cast<long>(whole)));
    return quantity(Rational(shortest_decimal(value)));
}

/// (a + b sqrt k) / d with small numbers, if the number is as near to one as doubles tell.
std::optional<Quantity> recognised(double value) {
    constexpr long largest_denominator = 36, largest_factor = 36;
    constexpr double rounding = 2e-14;
    for (long d = 1; d <= largest_denominator; ++d)
        for (const long k : {1L, 2L, 3L, 5L}) {
            const double root = k == 1 ? 0 : std::sqrt(static_cast<double>(k));
            const long most = k == 1 ? 0 : largest_factor;
            for (long b = -most; b <= most; ++b) {
                const double above = value * static_cast<double>(d) - static_cast<double>(b) * root;
                const double whole = std::round(above);
                if (std::fabs(whole) > 1000 ||
                    std::fabs(above - whole) > rounding * static_cast<double>(d))
                    continue;
                const Quantity plain = quantity(Rational(static_cast<long>(whole), d));
                if (b == 0) return plain;
                const bool single = plain.exact->is_zero();
                Expression root_of, part, sum;
                root_of.kind = Expression::Kind::call;
                root_of.name = "sqrt";
                root_of.operands = {quantity(Rational(k)).expression};
                part.kind = sum.kind = Expression::Kind::binary;
                part.name = "*";
                part.operands = {quantity(Rational(single ? b : std::abs(b), d)).expression,
                                 root_of};
                sum.name = b < 0 ? "-" : "+";
                sum.operands = {plain.expression, part};
                return evaluate(single ? part : sum, {});
            }
        }
    return std::nullopt;
}

/// The number as recognised, so that a lattice remains one, or else as a decimal.
Quantity coordinate(double value) {
    const auto found = recognised(value);
    return found ? *found : decimal(value);
}

/// 1/|mu|, exactly where |mu|^2 is a whole number.
Quantity reduction(const Displacement& displacement) {
    const auto square = ScalingRatio(displacement).integer_square();
    if (!square) return decimal(1 / displacement.ratio());
    const Integer root(static_cast<long>(std::llround(displacement.ratio())));
    if (root * root == *square) return quantity(Rational(Integer(1), root));
    Expression inverse_root;
    inverse_root.kind = Expression::Kind::call;
    inverse_root.name = "sqrt";
    inverse_root.operands = {quantity(Rational(Integer(1), *square)).expression};
    return evaluate(inverse_root, {});
}

/// z -> ratio e^(i degrees) z + offset.
IteratedFunctions::Map similarity(const Quantity& ratio, double degrees,
                                  std::complex<double> offset) {
    IteratedFunctions::Map map;
    map.similarity = std::pair(ratio, decimal(degrees));
    map.ratio = ratio.expression;
    const double turn = map.similarity->second.value / 180 * std::numbers::pi;
    const double c = ratio.value * std::cos(turn), s = ratio.value * std::sin(turn);
    const Quantity x = coordinate(offset.real()), y = coordinate(offset.imag());
    map.numbers.fill(quantity(0));
    map.numbers[4] = x;
    map.numbers[5] = y;
    map.map = {c, -s, s, c, x.value, y.value};
    if (map.similarity->second.exact->is_integer()) return map;
    const auto cosine = recognised(c), sine = recognised(s), opposite = recognised(-s);
    if (!cosine || !sine || !opposite) return map;
    map.similarity.reset();
    map.numbers = {*cosine, *opposite, *sine, *cosine, x, y};
    return map;
}

/// The recurrent set of a system's figure; errors name the system.
RecurrentSet set_of(const Model& system, const D0L& rules, const Budget& budget) {
    try {
        return RecurrentSet(system, rules, budget);
    } catch (const Error& error) {
        throw Error(system.name + ": " + error.what());
    }
}

/// From -180 (without it) to 180.
double normal(double degrees) {
    degrees = std::remainder(degrees, 360);
    return degrees <= -180 ? degrees + 360 : degrees;
}

}  // namespace

IteratedFunctions functions_of_curve(const Model& system, const Budget& budget) {
    const View<D0L> rules = as_d0l(system);
    if (!rules) throw Error(system.name + ": " + rules.reason());
    if (system.drawing.tropism) throw Error(system.name + ": strokes bend to a tropism");
    const RecurrentSet set = set_of(system, *rules, budget);
    const Unfolding& unfolding = set.unfolding();
    const std::complex<double> mu = set.displacement().factor();
    const double unit = 360.0 / static_cast<double>(set.order());

    IteratedFunctions found;
    found.name = system.name;
    found.title = system.title;
    found.source = system.source;
    found.states.clear();
    const auto& axiom = set.axiom();
    const bool single =
        axiom.size() == 1 && axiom[0].heading == 0 && axiom[0].offset == set.displacement().zero();
    if (!single) found.states.push_back("axiom");
    // The pieces reached, that of a single axiom first.
    std::vector<std::size_t> place(set.size(), 0), pieces;
    const auto add = [&](std::size_t piece) {
        place[piece] = found.states.size();
        pieces.push_back(piece);
        const std::size_t letters = unfolding.letters.size();
        std::string name = system.alphabet.name(unfolding.letters[piece % letters]);
        if (unfolding.phases > 1) name += "." + std::to_string(piece / letters);
        found.states.push_back(name);
    };
    if (single) add(axiom[0].piece);
    for (std::size_t piece = 0; piece < set.size(); ++piece)
        if (set.is_reached(piece) && !(single && piece == axiom[0].piece)) add(piece);

    const auto map_to = [&](std::size_t from, const RecurrentSet::Part& part,
                            std::complex<double> factor, const Quantity& ratio) {
        const double degrees =
            static_cast<double>(part.heading) * unit - std::arg(factor) * 180 / std::numbers::pi;
        IteratedFunctions::Map map =
            similarity(ratio, normal(degrees), set.displacement().value(part.offset) / factor);
        map.from = from;
        map.to = place[part.piece];
        map.name = "map " + std::to_string(found.maps.size() + 1);
        found.maps.push_back(std::move(map));
    };
    if (!single)
        for (const auto& part : axiom) map_to(0, part, 1, quantity(Rational(1)));
    const Quantity ratio = reduction(set.displacement());
    for (const std::size_t piece : pieces)
        for (const auto& part : set.parts(piece)) map_to(place[piece], part, mu, ratio);
    if (found.states.size() == 1) found.states = {""};
    found.check();
    return found;
}

}  // namespace algae
