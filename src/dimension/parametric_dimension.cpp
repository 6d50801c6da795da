#include "dimension/parametric_dimension.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "dimension/constant_expression.hpp"
#include "dimension/equal_lengths.hpp"
#include "dimension/ratio_sum.hpp"
#include "growth/components.hpp"

namespace algae {

namespace {

using Status = ExactDimension::Status;

/// Parts of states that draw for ever.
std::vector<RatioSum::Entry> lasting_entries(const RatioGraph& graph,
                                             const std::vector<bool>& drawing) {
    std::vector<RatioSum::Entry> found;
    for (std::size_t k = 0; k < graph.states.size(); ++k)
        for (const RatioGraph::Part& part : graph.states[k].parts)
            if (drawing[k] && !part.is_fence && drawing[part.state])
                found.push_back({k, part.state, part.ratio});
    return found;
}

GrowthMatrix counts(std::size_t states, const std::vector<RatioSum::Entry>& entries) {
    IntegerMatrix matrix(states, states);
    for (const RatioSum::Entry& entry : entries) matrix(entry.from, entry.to) += Integer(1);
    return growth_matrix(matrix);
}

/// The entries within a component, its states counted from 0.
std::vector<RatioSum::Entry> within(const Component& component,
                                    const std::vector<RatioSum::Entry>& entries) {
    const auto& letters = component.letters;
    const auto place = [&](std::size_t state) {
        return static_cast<std::size_t>(std::find(letters.begin(), letters.end(), state) -
                                        letters.begin());
    };
    std::vector<RatioSum::Entry> found;
    for (const RatioSum::Entry& entry : entries)
        if (place(entry.from) < letters.size() && place(entry.to) < letters.size())
            found.push_back({place(entry.from), place(entry.to), entry.ratio});
    return found;
}

/// Whether the figures of a component without branching become points beside the whole.
bool vanishes(const std::vector<RatioSum::Entry>& cycle, const WayGrowth& growth) {
    constexpr long bits = 192;
    Ball product(1, bits);
    for (const RatioSum::Entry& entry : cycle)
        product *= abs(enclosure(entry.ratio, bits)) / growth.enclosure(bits);
    return compare(product, Ball(1, bits)) == Order::less;
}

}  // namespace

ExactDimension parametric_dimension(const LSystem& system, const Budget& budget) {
    const RatioGraph graph = ratio_graph(system, budget);
    if (const auto equal = with_equal_lengths(graph)) {
        ExactDimension found = exact_dimension(*equal, budget);
        if (found.status != Status::none) {
            found.conditions.insert(found.conditions.begin(),
                                    "every rule multiplies lengths by the same number");
            return found;
        }
    }
    std::vector<bool> draws;
    for (const RatioGraph::State& state : graph.states) draws.push_back(state.draws);
    const std::vector<bool> drawing = lasting(graph, draws);
    if (std::none_of(drawing.begin(), drawing.end(), [](bool lasts) { return lasts; }))
        throw Error("nothing is drawn in late generations");
    const WayGrowth growth(graph, budget);
    const std::vector<RatioSum::Entry> entries = lasting_entries(graph, drawing);
    const Components all = components(counts(graph.states.size(), entries), budget);

    std::optional<RatioSum> largest;
    double dimension = 0;
    bool has_segments = false;
    for (const Component& component : all.list) {
        if (!component.rate) continue;
        std::vector<RatioSum::Entry> own = within(component, entries);
        if (*component.rate == Rate(1)) {
            const bool draws_itself =
                std::any_of(component.letters.begin(), component.letters.end(),
                            [&](std::size_t k) { return graph.states[k].draws; });
            has_segments = has_segments || (draws_itself && !vanishes(own, growth));
            continue;
        }
        RatioSum sum(component.letters.size(), std::move(own), growth);
        const double value = sum.enclosure(64).midpoint();
        if (largest && value <= dimension) continue;
        dimension = value;
        largest = std::move(sum);
    }
    ExactDimension found;
    if (largest && (!has_segments || dimension > 1)) {
        found.status = Status::upper_bound;
        found.value = found.similarity = DimensionFormula(*largest);
        found.conditions.push_back(
            "rules multiply lengths by constants, and m is the factor by which the ways from the "
            "beginnings to the ends of figures grow in each generation");
        found.conditions.push_back("whether parts overlap is not known");
        return found;
    }
    found.status = Status::exact;
    if (has_segments) {
        found.value = found.similarity = LogRatio(Rate(2), ScalingRatio(Integer(2)));
        found.conditions.push_back("segments stay segments");
    } else {
        found.value = found.similarity = LogRatio(Rate(1), ScalingRatio(Integer(2)));
        found.conditions.push_back("the parts that are drawn do not multiply");
    }
    return found;
}

}  // namespace algae
