#include "nature/similarity_dimension.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "dimension/constant_expression.hpp"
#include "dimension/log_ratio.hpp"
#include "dimension/ratio_sum.hpp"
#include "growth/components.hpp"

namespace algae {

namespace {

using Status = ExactDimension::Status;
using Entry = RatioSum::Entry;

GrowthMatrix counts(std::size_t states, const std::vector<IteratedFunctions::Map>& maps) {
    IntegerMatrix matrix(states, states);
    for (const auto& map : maps) matrix(map.from, map.to) += Integer(1);
    return growth_matrix(matrix);
}

std::vector<bool> reached(const IteratedFunctions& system) {
    std::vector<bool> found(system.states.size());
    found[0] = true;
    for (std::size_t round = 0; round < system.states.size(); ++round)
        for (const auto& map : system.maps)
            if (found[map.from]) found[map.to] = true;
    return found;
}

/// The square of a ratio, where that is a rational number.
std::optional<Rational> rational_square(const Expression& ratio) {
    if (const auto plain = rational_value(shortened(ratio))) return *plain * *plain;
    if (ratio.kind == Expression::Kind::call && ratio.name == "sqrt")
        return rational_value(shortened(ratio.operands.front()));
    if (ratio.kind == Expression::Kind::binary && ratio.name == "/") {
        const auto above = rational_square(ratio.operands[0]),
                   below = rational_square(ratio.operands[1]);
        if (above && below && !below->is_zero()) return *above / *below;
    }
    return std::nullopt;
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
    for (const auto& map : system.maps)
        if (!map.ratio) {
            found.conditions.push_back(map.name + " is no similarity");
            return found;
        }
    const std::vector<bool> is_reached = reached(system);
    const Components all = components(counts(system.states.size(), system.maps), budget);
    std::optional<double> largest;
    for (const Component& component : all.list) {
        if (!component.rate || !is_reached[component.letters.front()]) continue;
        const auto& letters = component.letters;
        const auto place = [&](std::size_t state) {
            return static_cast<std::size_t>(std::find(letters.begin(), letters.end(), state) -
                                            letters.begin());
        };
        std::vector<Entry> entries;
        bool to_points = false;
        for (const auto& map : system.maps) {
            if (place(map.from) == letters.size() || place(map.to) == letters.size()) continue;
            const Ball ratio = enclosure(*map.ratio, 64);
            if (sign(ratio) == 0)
                to_points = true;  // adds nothing
            else
                entries.push_back({place(map.from), place(map.to), *map.ratio});
        }
        if (to_points) continue;
        const bool single = *component.rate == Rate(1);
        DimensionFormula formula = LogRatio(Rate(1), ScalingRatio(Integer(2)));
        if (const auto log_ratio = equal_ratios(entries, *component.rate))
            formula = *log_ratio;
        else if (!single)
            formula = RatioSum(letters.size(), std::move(entries));
        const double value = formula.enclosure(64).midpoint();
        if (largest && value <= *largest) continue;
        largest = value;
        found.value = found.similarity = formula;
    }
    if (!largest) {
        found.conditions.push_back("a map takes everything to one point");
        return found;
    }
    found.status = Status::upper_bound;
    found.conditions.push_back("all maps are similarities");
    found.conditions.push_back("an upper bound unless the open set condition holds");
    return found;
}

}  // namespace algae
