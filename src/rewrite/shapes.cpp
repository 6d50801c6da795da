#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "exact/exact.hpp"
#include "rewrite/detail/shapes.hpp"
#include "rewrite/rewrite.hpp"
#include "system/system.hpp"
#include "watch/watch.hpp"

// Shape rules: boxes divided along an axis (div), filled by as many parts as fit (repeat), or replaced (I).
//
// All sizes are rationals, so that parts meet exactly. Absolute sizes come first, relative ones share what these leave.
// `distance(AXIS, SYMBOL)` in a condition is the gap to the nearest other box of that symbol in the generation that is rewritten;
// two sorted rows of ends for each axis and symbol find it in logarithmic time.

namespace algae {

char axis_name(std::size_t axis) { return "XYZ"[axis]; }

std::string box_text(const Alphabet& alphabet, const ShapeBox& box) {
    std::string text = alphabet.name(box.symbol);
    for (const Rational& place : box.origin) text += ' ' + shortest_text(place);
    for (const Rational& size : box.size) text += ' ' + shortest_text(size);
    return text;
}

Word symbols_of(const std::vector<ShapeBox>& boxes) {
    Word symbols;
    symbols.reserve(boxes.size());
    for (const ShapeBox& box : boxes) symbols.push_back(box.symbol);
    return symbols;
}

std::vector<Rational> lengths_of(const Rational& extent, const std::vector<PartSize>& sizes) {
    Rational lengths = 0, shares = 0;
    for (const PartSize& size : sizes) {
        if (sign(size.value) <= 0)
            throw Error("expected sizes above 0, found " + shortest_text(size.value) +
                        (size.relative ? "r" : ""));
        (size.relative ? shares : lengths) += size.value;
    }
    const Rational rest = extent - lengths;
    if (sign(rest) < 0)
        throw Error("expected sizes that add up to at most " + shortest_text(extent) + ", found " +
                    shortest_text(lengths));
    if (!shares.is_zero() && rest.is_zero())
        throw Error("expected sizes that leave something of " + shortest_text(extent) +
                    " for the relative ones, found " + shortest_text(lengths));
    std::vector<Rational> parts;
    for (const PartSize& size : sizes)
        parts.push_back(size.relative ? size.value * rest / shares : size.value);
    return parts;
}

Integer parts_that_fit(const Rational& extent, const Rational& size) {
    if (sign(size) <= 0) throw Error("expected a size above 0, found " + shortest_text(size));
    if (size > extent)
        throw Error("expected a size of at most " + shortest_text(extent) + ", found " +
                    shortest_text(size));
    return floor(extent / size);
}

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
    return " has " + counted(parts, "part") + " for the " + counted(cells, "place") +
           " that its sizes make";
}

Refusal beyond_shape(const Production& rule) {
    if (!rule.left.empty() || !rule.right.empty()) return " has a context";
    if (!rule.elsewhere.empty()) return " has a context condition";
    if (rule.probability && *rule.probability != 1) return " has a probability";
    if (!rule.shape) return " makes a word, not div, repeat or I";
    const std::size_t parameters = rule.predecessor.parameters.size();
    if (parameters != 0 && parameters != 3)
        return " has " + counted(parameters, "parameter") +
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
                   "' has " + counted(arguments.size(), "argument") +
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
        (i < sizes ? box.origin[i] : box.size[i - sizes]) = rational(evaluate(arguments[i], names));
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

Rational gap(const ShapeBox& left, const ShapeBox& right, std::size_t axis) {
    const Rational behind = right.origin[axis] - (left.origin[axis] + left.size[axis]);
    const Rational before = left.origin[axis] - (right.origin[axis] + right.size[axis]);
    return std::max({Rational(0), behind, before});
}

NearestBoxes::NearestBoxes(const ShapeSystem& system, const std::vector<ShapeBox>& boxes) {
    for (const auto& asked : system.distances) {
        Ends& ends = ends_[{asked.axis, asked.symbol}];
        if (!ends.low.empty()) continue;
        for (const ShapeBox& box : boxes) {
            if (box.symbol != asked.symbol) continue;
            ends.low.push_back(box.origin[asked.axis]);
            ends.high.push_back(box.origin[asked.axis] + box.size[asked.axis]);
        }
        std::sort(ends.low.begin(), ends.low.end());
        std::sort(ends.high.begin(), ends.high.end());
    }
}

std::optional<Rational> NearestBoxes::distance(const ShapeBox& box, std::size_t axis,
                                               Symbol symbol) const {
    const Ends& ends = ends_.at({axis, symbol});
    const bool itself = box.symbol == symbol;
    if (ends.low.size() == static_cast<std::size_t>(itself)) return std::nullopt;
    const Rational low = box.origin[axis], high = low + box.size[axis];
    // Boxes have an extent, so those that begin before its end and do not end before it begins are
    // counted by two searches.
    const auto next = std::upper_bound(ends.low.begin(), ends.low.end(), high);
    const auto last = std::lower_bound(ends.high.begin(), ends.high.end(), low);
    const auto meeting = (next - ends.low.begin()) - (last - ends.high.begin());
    if (meeting > static_cast<std::ptrdiff_t>(itself)) return Rational(0);
    std::optional<Rational> nearest;
    if (next != ends.low.end()) nearest = *next - high;
    if (last != ends.high.begin())
        if (const Rational before = low - *std::prev(last); !nearest || before < *nearest)
            nearest = before;
    return nearest;
}

namespace {

void check_count(const Integer& boxes, const Budget& budget) {
    if (boxes > Integer(budget.letters))
        throw BoundReached(Bound::letters, "a step makes at least " + to_string(boxes) +
                                               " boxes, more than the " +
                                               std::to_string(budget.letters) + " allowed" +
                                               budget.by(Bound::letters));
    budget.check_memory(static_cast<std::uint64_t>(boxes.to_int64()) * sizeof(ShapeBox), "boxes");
}

/// A rule at work on a box: the names in its expressions are the sizes of the box and, in its
/// condition, distances from other boxes.
class Application {
public:
    Application(const ShapeSystem& shapes, const Production& rule, const ShapeBox& box,
                const NearestBoxes& nearest, const Budget& budget)
        : shapes_(shapes),
          system_(*shapes.system),
          rule_(rule),
          box_(box),
          nearest_(nearest),
          budget_(budget) {
        for (std::size_t i = 0; i < rule.predecessor.parameters.size(); ++i)
            sizes_.push_back({Expression{}, box.size[i], box.size[i].to_double()});
    }

    bool applies() const {
        if (!rule_.condition) return true;
        std::map<std::string, Quantity> distances;
        const Quantity holds = value(
            *rule_.condition, [&](const std::string& name) { return distance(name, distances); });
        return holds.exact ? !holds.exact->is_zero() : holds.value != 0;
    }

    std::vector<ShapeBox> parts() const {
        const ShapeSuccessor& shape = *rule_.shape;
        if (shape.operation == "I") {
            ShapeBox box = box_;
            box.symbol = shape.parts.at(0);
            return {box};
        }
        return shape.operation == "repeat" ? repeated(shape) : divided(shape);
    }

private:
    [[noreturn]] void fail(const Place& place, const std::string& message) const {
        throw Error(to_string(place) + ": " + message + ", for the box " +
                    box_text(system_.alphabet, box_));
    }

    const Quantity* distance(const std::string& text,
                             std::map<std::string, Quantity>& distances) const {
        if (const auto known = distances.find(text); known != distances.end())
            return &known->second;
        for (const ShapeSystem::Distance& asked : shapes_.distances) {
            if (asked.text != text) continue;
            const auto found = nearest_.distance(box_, asked.axis, asked.symbol);
            const double rounded =
                found ? found->to_double() : std::numeric_limits<double>::infinity();
            return &distances.emplace(text, Quantity{Expression{}, found, rounded}).first->second;
        }
        return nullptr;
    }

    Quantity value(const Expression& expression, const Names& others) const {
        const auto names = [&](const std::string& name) -> const Quantity* {
            const auto& parameters = rule_.predecessor.parameters;
            const auto found = std::find(parameters.begin(), parameters.end(), name);
            if (found != parameters.end())
                return &sizes_[static_cast<std::size_t>(found - parameters.begin())];
            for (const auto& [constant, known] : system_.constants)
                if (constant == name) return &known;
            return others ? others(name) : nullptr;
        };
        try {
            return evaluate(expression, names);
        } catch (const Diagnostics& wrong) {
            fail(wrong.findings().front().place, wrong.findings().front().message);
        }
    }

    std::vector<ShapeBox> repeated(const ShapeSuccessor& shape) const {
        const std::size_t axis = std::string_view("XYZ").find(shape.axis);
        const Expression& size = shape.sizes.at(0).value;
        const Rational wanted = rational(value(size, {}));
        Integer count;
        try {
            count = parts_that_fit(box_.size[axis], wanted);
        } catch (const Error& wrong) {
            explain(size, axis, wrong);
        }
        check_count(count, budget_);
        const Rational length = box_.size[axis] / Rational(count);
        std::vector<ShapeBox> parts(static_cast<std::size_t>(count.to_int64()), box_);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            parts[i].symbol = shape.parts.at(0);
            parts[i].origin[axis] += length * Rational(i);
            parts[i].size[axis] = length;
        }
        return parts;
    }

    std::vector<ShapeBox> divided(const ShapeSuccessor& shape) const {
        std::vector<ShapeBox> cells{box_};
        const std::string axes =
            shape.axis.size() > 1 ? shape.axis : std::string(shape.sizes.size(), shape.axis.at(0));
        for (std::size_t first = 0; first < axes.size();) {
            // The sizes up to the first of another axis cut along this one.
            const std::size_t last =
                std::min(axes.find_first_not_of(axes[first], first), axes.size());
            const std::size_t axis = std::string_view("XYZ").find(axes[first]);
            const std::vector<Rational> lengths = lengths_along(axis, shape, first, last);
            check_count(Integer(cells.size()) * Integer(lengths.size()), budget_);
            std::vector<ShapeBox> cut;
            for (const ShapeBox& cell : cells) {
                Rational place = cell.origin[axis];
                for (const Rational& length : lengths) {
                    cut.push_back(cell);
                    cut.back().origin[axis] = place;
                    cut.back().size[axis] = length;
                    place += length;
                }
            }
            cells = std::move(cut);
            first = last;
        }
        for (std::size_t i = 0; i < cells.size(); ++i)
            cells[i].symbol = shape.parts.size() == 1 ? shape.parts[0] : shape.parts.at(i);
        return cells;
    }

    std::vector<Rational> lengths_along(std::size_t axis, const ShapeSuccessor& shape,
                                        std::size_t first, std::size_t last) const {
        std::vector<PartSize> sizes;
        for (std::size_t i = first; i < last; ++i)
            sizes.push_back({rational(value(shape.sizes[i].value, {})), shape.sizes[i].relative});
        try {
            return lengths_of(box_.size[axis], sizes);
        } catch (const Error& wrong) {
            explain(shape.sizes[first].value, axis, wrong);
        }
    }

    [[noreturn]] void explain(const Expression& size, std::size_t axis, const Error& wrong) const {
        fail(size.place, std::string(wrong.what()) + ", along " + axis_name(axis));
    }

    const ShapeSystem& shapes_;
    const LSystem& system_;
    const Production& rule_;
    const ShapeBox& box_;
    const NearestBoxes& nearest_;
    const Budget& budget_;
    std::vector<Quantity> sizes_;
};

/// The parts, or nothing where no rule applies.
std::optional<std::vector<ShapeBox>> made_of(const ShapeSystem& shapes, const ShapeBox& box,
                                             const NearestBoxes& nearest, const Budget& budget) {
    const Production* chosen = nullptr;
    for (const std::size_t i : shapes.rules.at(box.symbol)) {
        const Production& rule = shapes.system->rules[i];
        if (!Application(shapes, rule, box, nearest, budget).applies()) continue;
        if (chosen)
            throw Error(to_string(rule.place) + ": expected one rule for the box " +
                        box_text(shapes.system->alphabet, box) + ", found that the rule at " +
                        to_string(chosen->place) + " applies too");
        chosen = &rule;
    }
    if (!chosen) return std::nullopt;
    return Application(shapes, *chosen, box, nearest, budget).parts();
}

}  // namespace

std::vector<ShapeBox> parts_of(const ShapeSystem& system, const ShapeBox& box,
                               const Budget& budget) {
    return made_of(system, box, NearestBoxes(system, {box}), budget)
        .value_or(std::vector<ShapeBox>{box});
}

std::vector<ShapeBox> boxes_after(const ShapeSystem& system, std::vector<ShapeBox> boxes,
                                  std::uint64_t n, const Budget& budget) {
    bool changes = true;
    WorkCount generations("generation", n), of_boxes("boxes");
    for (std::uint64_t step = 0; step < n && changes; ++step) {
        changes = false;
        generations.at(step + 1);
        of_boxes.at(boxes.size());
        const NearestBoxes nearest(system, boxes);
        std::vector<ShapeBox> next;
        std::size_t unchecked = 0;
        for (ShapeBox& box : boxes) {
            if (unchecked++ % 4096 == 0) budget.check();
            if (auto parts = made_of(system, box, nearest, budget)) {
                changes = true;
                check_count(Integer(next.size()) + Integer(parts->size()), budget);
                std::move(parts->begin(), parts->end(), std::back_inserter(next));
            } else {
                next.push_back(std::move(box));
            }
        }
        boxes = std::move(next);
    }
    return boxes;
}

}  // namespace algae
