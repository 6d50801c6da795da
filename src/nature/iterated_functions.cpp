#include "nature/iterated_functions.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "nature/chaos_game.hpp"

namespace algae {

namespace {

std::string shown(double value) {
    char text[32];
    return {text,
            std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr};
}

/// "0.99", exactly where all of them are exact.
std::string sum_text(const std::vector<IteratedFunctions::Map>& maps, double sum) {
    Rational exact = 0;
    for (const auto& map : maps) {
        if (!map.probability->exact) return shown(sum);
        exact += *map.probability->exact;
    }
    return shortest_text(exact);
}

}  // namespace

std::vector<bool> IteratedFunctions::recurrent_states() const {
    const std::size_t count = states.size();
    std::vector<std::vector<bool>> leads(count, std::vector<bool>(count));
    for (const Map& map : maps) leads[map.from][map.to] = true;
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t i = 0; i < count; ++i)
            if (leads[i][k])
                for (std::size_t j = 0; j < count; ++j)
                    if (leads[k][j]) leads[i][j] = true;
    std::vector<bool> found(count);
    for (std::size_t i = 0; i < count; ++i) found[i] = leads[i][i];
    return found;
}

void IteratedFunctions::check() const {
    if (maps.empty())
        throw Error(name + ": has no maps; expected lines such as `map 0.5 0 0 0.5 0 0`");
    const std::vector<bool> recurrent = recurrent_states();
    std::vector<bool> mapped(states.size());
    for (const Map& map : maps) {
        mapped[map.from] = true;
        const double stretch = norm(map.map);
        if (recurrent[map.from] && !(stretch < 1))
            throw Error(name + ": " + map.name + " does not contract: its norm is " +
                        shown(stretch) + ", expected less than 1");
    }
    for (std::size_t i = 0; i < states.size(); ++i)
        if (!mapped[i]) throw Error(name + ": the state " + states[i] + " has no map");
    const bool said = std::any_of(maps.begin(), maps.end(),
                                  [](const Map& map) { return map.probability.has_value(); });
    if (!said) return;
    double sum = 0;
    for (const Map& map : maps) {
        if (!map.probability)
            throw Error(name + ": " + map.name + " has no probability, others do");
        if (!(map.probability->value > 0))
            throw Error(name + ": the probability of " + map.name + " is " +
                        shown(map.probability->value) + ", expected more than 0");
        sum += map.probability->value;
    }
    if (std::fabs(sum - 1) > 1e-12)
        throw Error(name + ": the probabilities add up to " + sum_text(maps, sum) + ", expected 1");
}

double IteratedFunctions::contraction() const {
    const std::vector<bool> recurrent = recurrent_states();
    double largest = 0;
    for (const Map& map : maps)
        if (recurrent[map.from]) largest = std::max(largest, norm(map.map));
    return largest;
}

std::vector<double> IteratedFunctions::chances() const {
    std::vector<double> found;
    if (maps.front().probability) {
        for (const Map& map : maps) found.push_back(map.probability->value);
        return found;
    }
    double largest = 0, sum = 0;
    for (const Map& map : maps) largest = std::max(largest, std::fabs(determinant(map.map)));
    for (const Map& map : maps) {
        found.push_back(largest > 0 ? std::max(std::fabs(determinant(map.map)), largest / 100)
                                    : 1.0);
        sum += found.back();
    }
    for (double& chance : found) chance /= sum;
    return found;
}

std::vector<RelativeFigure> IteratedFunctions::figures(const Budget& budget) const {
    const std::string what = title.empty() ? name : title;
    std::vector<RelativeFigure> found;
    const std::uint64_t count = points.value_or(50'000);
    found.push_back(
        {chaos_game(*this, count, budget), what + ", " + std::to_string(count) + " points", what});
    return found;
}

}  // namespace algae
