#include "nature/curve_functions.hpp"

#include <charconv>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "dimension/log_ratio.hpp"
#include "dimension/recurrent_set.hpp"

namespace algae {

namespace {

/// The decimal that is this double; what is nothing but rounding beside 1 is 0 or whole.
Quantity decimal(double value) {
    const double whole = std::round(value);
    if (std::fabs(value - whole) < 1e-13) return quantity(Rational(static_cast<long>(whole)));
    char text[32];
    const char* const end = std::to_chars(text, text + sizeof text, value).ptr;
    return quantity(Rational(std::string_view(text, static_cast<std::size_t>(end - text))));
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
    const Quantity x = decimal(offset.real()), y = decimal(offset.imag());
    map.numbers = {quantity(Rational(0)),
                   quantity(Rational(0)),
                   quantity(Rational(0)),
                   quantity(Rational(0)),
                   x,
                   y};
    map.map = {c, -s, s, c, x.value, y.value};
    return map;
}

/// The recurrent set of a system's figure; errors name the system.
RecurrentSet set_of(const LSystem& system, const D0L& rules, const Budget& budget) {
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

IteratedFunctions functions_of_curve(const LSystem& system, const Budget& budget) {
    const View<D0L> rules = as_d0l(system);
    if (!rules) throw Error(system.name + ": " + rules.reason());
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
