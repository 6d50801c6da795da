#include <fmt/format.h>

#include "cli/growth_report.hpp"
#include "cli/numbers.hpp"

namespace algae::cli {

namespace {

std::string rules(const OL& system, const std::vector<std::size_t>& choices) {
    std::string out;
    for (std::size_t i = 0; i < system.letters.size(); ++i) {
        const Symbol a = system.letters[i];
        if (system.successors[a].size() < 2) continue;
        if (!out.empty()) out += "; ";
        out += system.alphabet->name(a) + " -> " + spell(*system.alphabet, system.successors[a][choices[i]]);
    }
    return out.empty() ? "every letter has one rule" : out;
}

nlohmann::ordered_json numbers(const std::vector<Integer>& values, std::uint64_t first) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (std::size_t n = first; n < values.size(); ++n) out.push_back(nlohmann::ordered_json(json_number(values[n])));
    return out;
}

}  // namespace

std::string bounds_page(const OL& system, const LengthBounds& bounds, std::uint64_t first) {
    std::string out = "generation  least  greatest\n";
    for (std::uint64_t n = first; n < bounds.least.size(); ++n)
        out += fmt::format("{:<10}  {}  {}\n", n, to_string(bounds.least[n]), to_string(bounds.most[n]));
    out += "least(a, n) is the minimum, greatest(a, n) the maximum, over the rules a -> u of the sums over the letters of u "
           "at n - 1.\n";
    out += fmt::format("First choice for the least in generation {}:     {}\n", bounds.least.size() - 1,
                       rules(system, bounds.least_choice));
    out += fmt::format("First choice for the greatest in generation {}:  {}\n", bounds.least.size() - 1,
                       rules(system, bounds.most_choice));
    return out;
}

nlohmann::ordered_json bounds_json(const OL& system, const LengthBounds& bounds, std::uint64_t first) {
    return {{"from", first},
            {"least", numbers(bounds.least, first)},
            {"greatest", numbers(bounds.most, first)},
            {"least_choice", rules(system, bounds.least_choice)},
            {"greatest_choice", rules(system, bounds.most_choice)}};
}

}  // namespace algae::cli
