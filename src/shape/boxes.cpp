#include "shape/boxes.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include "base/error.hpp"
#include "shape/division.hpp"
#include "shape/nearest.hpp"

namespace algae {

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
        std::vector<Share> sizes;
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
    for (std::uint64_t step = 0; step < n && changes; ++step) {
        changes = false;
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
