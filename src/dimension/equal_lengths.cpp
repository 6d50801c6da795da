#include "dimension/equal_lengths.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace algae {

namespace {

/// Whether all lengths are multiplied by one number.
bool has_one_ratio(const RatioGraph& graph) {
    const Expression* ratio = nullptr;
    for (const RatioGraph::State& state : graph.states)
        for (const RatioGraph::Part& part : state.parts) {
            if (part.is_fence || !graph.states[part.state].matters) continue;
            if (ratio && !(*ratio == part.ratio)) return false;
            ratio = &part.ratio;
        }
    return true;
}

bool stays(const RatioGraph& graph, std::size_t k) {
    const auto& parts = graph.states[k].parts;
    return parts.size() == 1 && !parts[0].is_fence && parts[0].state == k;
}

/// The largest angle that 360 degrees and all turns are multiples of.
Rational common_angle(const RatioGraph& graph) {
    Rational common = 360;
    for (const RatioGraph::State& state : graph.states)
        for (Rational rest = abs(state.degrees); !rest.is_zero();) {
            const Rational next = common - rest * Rational(floor(common / rest));
            common = rest;
            rest = next;
        }
    return common;
}

}  // namespace

std::optional<LSystem> with_equal_lengths(const RatioGraph& graph) {
    constexpr long most_directions = 720;
    if (!has_one_ratio(graph)) return std::nullopt;
    const Rational unit = common_angle(graph);
    if (unit * Rational(most_directions) < Rational(360)) return std::nullopt;
    LSystem system;
    system.settings.angle = quantity(unit);
    std::vector<Word> words;
    for (std::size_t k = 0; k < graph.states.size(); ++k) {
        const RatioGraph::State& state = graph.states[k];
        if (!state.degrees.is_zero()) {
            if (!stays(graph, k)) return std::nullopt;
            const Rational times = abs(state.degrees) / unit;
            const Rational turns =
                times - Rational(360) / unit * Rational(floor(times * unit / Rational(360)));
            const Symbol turn = system.alphabet.symbol(sign(state.degrees) > 0 ? "+" : "-");
            words.emplace_back(static_cast<std::size_t>(turns.numerator().to_int64()), turn);
        } else {
            const std::string kind = state.draws ? "F_" : state.moves ? "f_" : "X_";
            words.push_back({system.alphabet.symbol(kind + std::to_string(k))});
        }
    }
    const Symbol open = system.alphabet.symbol("["), close = system.alphabet.symbol("]");
    const auto word = [&](const std::vector<RatioGraph::Part>& parts) {
        Word found;
        for (const RatioGraph::Part& part : parts) {
            if (part.is_fence)
                found.push_back(part.opens ? open : close);
            else
                found.insert(found.end(), words[part.state].begin(), words[part.state].end());
        }
        return found;
    };
    for (std::size_t k = 0; k < graph.states.size(); ++k) {
        if (!graph.states[k].degrees.is_zero()) continue;
        Production rule;
        rule.predecessor.symbol = words[k].front();
        rule.successor.letters = word(graph.states[k].parts);
        system.rules.push_back(std::move(rule));
    }
    system.axiom.letters = word(graph.axiom);
    return system;
}

}  // namespace algae
