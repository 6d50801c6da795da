#include "nature/iterated_functions.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "nature/attractor.hpp"
#include "nature/chaos_game.hpp"
#include "nature/copies.hpp"
#include "nature/similarity_dimension.hpp"

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
    if (generations) {
        for (std::uint64_t n = generations->first; n <= generations->second; ++n)
            found.push_back({copies(*this, n, budget), what + ", generation " + std::to_string(n),
                             "n = " + std::to_string(n)});
    } else if (points) {
        const std::string count = std::to_string(*points) + " points";
        found.push_back(
            {chaos_game(*this, *points, budget), what + ", " + count, what + ", " + count});
    } else {
        found.push_back({std::make_unique<AttractorFigure>(*this), what + ", the attractor", what});
    }
    return found;
}

RelativeFigure IteratedFunctions::measured_figure(const Budget& budget) const {
    if (points || generations) return Relative::measured_figure(budget);
    return {std::make_unique<AttractorFigure>(*this),
            (title.empty() ? name : title) + ", the attractor", ""};
}

std::optional<ExactDimension> IteratedFunctions::exact_dimension(const Budget& budget) const {
    return similarity_dimension(*this, budget);
}

std::vector<RelativeFact> IteratedFunctions::facts(const Budget& budget) const {
    std::vector<RelativeFact> found;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    std::string text = std::to_string(maps.size());
    const std::vector<double> chance = chances();
    for (std::size_t m = 0; m < maps.size(); ++m) {
        const Point fixed = fixed_point(maps[m].map);
        const bool own = maps[m].from == maps[m].to && norm(maps[m].map) < 1;
        nlohmann::ordered_json one{{"norm", norm(maps[m].map)}};
        text += "\n  " + maps[m].name + ": norm " + shown(norm(maps[m].map));
        if (own) {
            one["fixed_point"] = {fixed.x, fixed.y};
            text += ", fixed point (" + shown(fixed.x) + ", " + shown(fixed.y) + ")";
        }
        if (states.size() == 1) {
            one["probability"] = chance[m];
            text += ", probability " + shown(chance[m]);
        } else {
            one["from"] = states[maps[m].from];
            one["to"] = states[maps[m].to];
        }
        all.push_back(std::move(one));
    }
    found.push_back({"maps", text, all});
    const double s = contraction();
    found.push_back({"contraction", shown(s), s});
    Box box = attractor_boxes(*this).front();
    const double rounding = 1e-9 * std::max(box.breadth(), box.height());
    for (double* const side : {&box.low.x, &box.low.y, &box.high.x, &box.high.y})
        if (std::fabs(*side) < rounding) *side = 0;
    found.push_back({"bounding_box",
                     "[" + shown(box.low.x) + ", " + shown(box.high.x) + "] x [" +
                         shown(box.low.y) + ", " + shown(box.high.y) + "]",
                     {{"min", {box.low.x, box.low.y}}, {"max", {box.high.x, box.high.y}}}});
    const ExactDimension dimension = similarity_dimension(*this, budget);
    if (dimension.value)
        found.push_back(
            {"similarity_dimension",
             dimension.value->text() +
                 (dimension.value->rational() ? "" : " = " + dimension.value->decimal(6)) +
                 ", an upper bound unless the open set condition holds",
             {{"formula", dimension.value->text()},
              {"value", dimension.value->enclosure(64).midpoint()}}});
    else
        found.push_back({"similarity_dimension", "none: " + dimension.conditions.front(), nullptr});
    return found;
}

}  // namespace algae
