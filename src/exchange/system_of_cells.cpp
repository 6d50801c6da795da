#include "exchange/system_of_cells.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "notation/read.hpp"

namespace algae {

namespace {

constexpr std::size_t most_rules = 20'000;

/// The states of a number's digits in base `states`, `count` of them.
std::vector<std::uint8_t> digits(std::size_t number, std::uint32_t states, std::size_t count) {
    std::vector<std::uint8_t> found(count);
    for (std::size_t i = count; i-- > 0; number /= states)
        found[i] = static_cast<std::uint8_t>(number % states);
    return found;
}

std::size_t power(std::size_t base, std::size_t exponent) {
    std::size_t product = 1;
    while (exponent-- > 0) product = std::min(product * base, most_rules + 1);
    return product;
}

std::string word(const std::vector<std::uint8_t>& states, std::size_t first, std::size_t count) {
    std::string text;
    for (std::size_t i = first; i < first + count; ++i) text += state_character(states[i]);
    return text;
}

}  // namespace

LSystem system_of_cells(const CellularAutomaton& automaton) {
    const CellRule& rule = automaton.rule;
    if (rule.dimensions != 1)
        throw Error(automaton.name + ": lies in the plane, and the letters of a word on a line");
    if (automaton.boundary.periodic)
        throw Error(automaton.name +
                    ": its edges are joined, and no context of a word reaches from its end to its "
                    "beginning; expected `boundary fixed 0` or another state");
    const auto radius = static_cast<std::size_t>(rule.radius());
    std::size_t count = 0;
    for (std::size_t left = 0; left <= radius; ++left)
        for (std::size_t right = 0; right <= radius; ++right)
            count += power(rule.states, left + 1 + right);
    if (count > most_rules) throw Error(automaton.name + ": would have more than 20000 rules");
    std::string text;
    if (!automaton.title.empty()) text += "title " + automaton.title + "\n";
    if (!automaton.source.empty()) text += "source " + automaton.source + "\n";
    text += "axiom " + word(automaton.start.cells, 0, automaton.start.cells.size()) + "\n";
    // The longest contexts first.
    for (std::size_t size = 2 * radius + 1; size-- > 0;)
        for (std::size_t left = size > radius ? size - radius : 0; left <= std::min(size, radius);
             ++left) {
            const std::size_t right = size - left;
            for (std::size_t number = 0; number < power(rule.states, size + 1); ++number) {
                const auto seen = digits(number, rule.states, size + 1);
                std::size_t local = 0;
                for (std::size_t i = 0; i < 2 * radius + 1; ++i) {
                    const bool inside = i + left >= radius && i <= radius + right;
                    local = local * rule.states +
                            (inside ? seen[i + left - radius] : automaton.boundary.outside);
                }
                if (left > 0) text += word(seen, 0, left) + " < ";
                text += state_character(seen[left]);
                if (right > 0) text += " > " + word(seen, left + 1, right);
                text += std::string(" -> ") + state_character(rule.table[local]) + "\n";
            }
        }
    return read_lsystem(text, automaton.name);
}

}  // namespace algae
