#include "shape/shape_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace algae {

namespace {

using Refusal = std::string;

std::string at(const Place& place) { return "the rule at " + to_string(place); }

/// Why a division has another number of parts than of places for them; empty if it has not.
Refusal wrong_parts(const ShapeSuccessor& shape) {
    const std::size_t parts = shape.parts.size();
    if (shape.operation == "repeat" && parts != 1)
        return " has " + std::to_string(parts) + " parts, and repeat takes one";
    if (shape.operation == "repeat" && shape.sizes.at(0).relative)
        return " has a relative size, and repeat takes a length";
    if (shape.operation != "div") return {};
    std::size_t cells = shape.sizes.size();
    if (shape.axis.size() > 1) {
        cells = 1;
        for (const char axis : {'X', 'Y', 'Z'})
            if (const auto cuts = std::count(shape.axis.begin(), shape.axis.end(), axis))
                cells *= static_cast<std::size_t>(cuts);
        if (parts == 1) return {};
    }
    if (parts == cells) return {};
    return " has " + std::to_string(parts) + (parts == 1 ? " part" : " parts") + " for the " +
           std::to_string(cells) + (cells == 1 ? " place" : " places") + " that its sizes make";
}

Refusal beyond_shape(const Production& rule) {
    if (!rule.left.empty() || !rule.right.empty()) return " has a context";
    if (!rule.elsewhere.empty()) return " has a context condition";
    if (rule.probability && *rule.probability != 1) return " has a probability";
    if (!rule.shape) return " makes a word, not div, repeat or I";
    const std::size_t parameters = rule.predecessor.parameters.size();
    if (parameters != 0 && parameters != 3)
        return " has " + std::to_string(parameters) +
               (parameters == 1 ? " parameter" : " parameters") +
               ", and a box has three, its sizes along X, Y and Z";
    return wrong_parts(*rule.shape);
}

Refusal beyond_shape(const LSystem& system) {
    if (holds_words(system)) return "there are systems or words within it";
    if (!system.tables.empty()) return "it has tables";
    if (!system.terminals.empty()) return "it has terminals";
    for (const Production& rule : system.rules)
        if (const Refusal reason = beyond_shape(rule); !reason.empty())
            return at(rule.place) + reason;
    for (const auto& [position, arguments] : system.axiom.arguments)
        if (arguments.size() != 3 && arguments.size() != 6)
            return "the axiom's '" + system.alphabet.name(system.axiom.letters[position]) +
                   "' has " + std::to_string(arguments.size()) +
                   (arguments.size() == 1 ? " argument" : " arguments") +
                   ", and a box has three, its sizes, or six, its origin "
                   "and its sizes";
    return {};
}

ShapeBox box_of(const LSystem& system, std::size_t position) {
    ShapeBox box;
    box.symbol = system.axiom.letters[position];
    box.size = {1, 1, 1};
    const auto found = system.axiom.arguments.find(position);
    if (found == system.axiom.arguments.end()) return box;
    const auto names = [&](const std::string& name) -> const Quantity* {
        for (const auto& [constant, value] : system.constants)
            if (constant == name) return &value;
        return nullptr;
    };
    const std::vector<Expression>& arguments = found->second;
    const std::size_t sizes = arguments.size() - 3;
    for (std::size_t i = 0; i < arguments.size(); ++i)
        (i < sizes ? box.origin[i] : box.size[i - sizes]) =
            rational(evaluate(arguments[i], names));
    for (std::size_t i = 0; i < 3; ++i)
        if (sign(box.size[i]) <= 0)
            throw Error(to_string(arguments[sizes + i].place) + ": expected a size above 0 along " +
                        axis_name(i) + ", found " + shortest_text(box.size[i]));
    return box;
}

/// Adds the distances in an expression to those of the system.
void add_distances(const Expression& expression, ShapeSystem& shapes) {
    for (const Expression& operand : expression.operands) add_distances(operand, shapes);
    if (!is_distance(expression)) return;
    const std::string text = to_text(expression);
    const auto known = std::find_if(shapes.distances.begin(), shapes.distances.end(),
                                    [&](const auto& other) { return other.text == text; });
    if (known != shapes.distances.end()) return;
    const auto symbol = shapes.system->alphabet.find(expression.operands.at(1).name);
    if (!symbol)
        throw Error(to_string(expression.place) + ": expected a symbol of the system, found '" +
                    expression.operands[1].name + "'");
    shapes.distances.push_back(
        {text, std::string_view("XYZ").find(expression.operands.at(0).name), *symbol});
}

}  // namespace

Rational rational(const Quantity& quantity) {
    return quantity.exact ? *quantity.exact : Rational(fmt::format("{}", quantity.value));
}

View<ShapeSystem> as_shape(const LSystem& system) {
    if (const Refusal reason = beyond_shape(system); !reason.empty())
        return View<ShapeSystem>::refused("not a system of shape rules: " + reason);
    ShapeSystem shapes;
    shapes.system = std::make_shared<const LSystem>(system);
    for (std::size_t i = 0; i < system.axiom.letters.size(); ++i)
        shapes.axiom.push_back(box_of(system, i));
    shapes.rules.resize(system.alphabet.size());
    for (std::size_t i = 0; i < system.rules.size(); ++i) {
        auto& of = shapes.rules[system.rules[i].predecessor.symbol];
        const bool twice = std::any_of(of.begin(), of.end(), [&](std::size_t other) {
            return system.rules[other] == system.rules[i];
        });
        if (twice) continue;
        of.push_back(i);
        if (system.rules[i].condition) add_distances(*system.rules[i].condition, shapes);
    }
    return shapes;
}

}  // namespace algae
