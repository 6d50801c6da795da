#include "nature/cell_rule.hpp"

#include <algorithm>
#include <cstdlib>

#include "base/error.hpp"

namespace algae {

namespace {

/// The last `count` digits of a number in base `base`, the last one first; throws if it has more.
std::vector<std::uint8_t> digits(Integer number, std::uint32_t base, std::size_t count,
                                 const char* what) {
    std::vector<std::uint8_t> found;
    const Integer original = number, divisor(base);
    for (std::size_t i = 0; i < count; ++i) {
        const Integer digit = remainder(number, divisor);
        found.push_back(static_cast<std::uint8_t>(digit.to_double()));
        number = exact_divide(number - digit, divisor);
    }
    if (!number.is_zero() || original < Integer(0)) {
        const std::string most = std::to_string(base) + "^" + std::to_string(count);
        throw Error(
            std::string("the ") + what + " " + to_string(original) +
            " is out of range: expected 0 to " +
            (count <= 64 ? to_string(power(Integer(base), count) - Integer(1)) : most + " - 1"));
    }
    return found;
}

/// The local configuration of a number, digit by digit from the first cell.
std::vector<std::uint8_t> configuration(std::size_t number, std::uint32_t states,
                                        std::size_t cells) {
    std::vector<std::uint8_t> found(cells);
    for (std::size_t i = cells; i-- > 0; number /= states)
        found[i] = static_cast<std::uint8_t>(number % states);
    return found;
}

CellRule blank(std::uint32_t states, const std::vector<CellOffset>& neighbourhood) {
    CellRule rule;
    rule.states = states;
    rule.neighbourhood = neighbourhood;
    rule.dimensions = std::any_of(neighbourhood.begin(), neighbourhood.end(),
                                  [](const CellOffset& offset) { return offset.row != 0; })
                          ? 2
                          : 1;
    return rule;
}

}  // namespace

int CellRule::radius() const {
    int farthest = 0;
    for (const CellOffset& offset : neighbourhood)
        farthest = std::max({farthest, std::abs(offset.column), std::abs(offset.row)});
    return farthest;
}

bool CellRule::is_elementary() const {
    return states == 2 && neighbourhood == line_neighbourhood(1);
}

std::vector<CellOffset> line_neighbourhood(int radius) {
    std::vector<CellOffset> found;
    for (int x = -radius; x <= radius; ++x) found.push_back({x, 0});
    return found;
}

std::vector<CellOffset> moore_neighbourhood(int radius) {
    std::vector<CellOffset> found;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) found.push_back({x, y});
    return found;
}

std::vector<CellOffset> neumann_neighbourhood(int radius) {
    std::vector<CellOffset> found;
    for (const CellOffset& offset : moore_neighbourhood(radius))
        if (std::abs(offset.column) + std::abs(offset.row) <= radius) found.push_back(offset);
    return found;
}

std::size_t cell_table_size(std::uint32_t states, std::size_t neighbours) {
    std::size_t size = 1;
    for (std::size_t i = 0; i < neighbours; ++i) {
        if (size > largest_cell_table / states)
            throw Error("a table for " + std::to_string(neighbours) + " cells of " +
                        std::to_string(states) + " states has more than 2^24 entries");
        size *= states;
    }
    return size;
}

CellRule numbered_rule(const Integer& number, std::uint32_t states,
                       const std::vector<CellOffset>& neighbourhood) {
    CellRule rule = blank(states, neighbourhood);
    rule.table = digits(number, states, cell_table_size(states, neighbourhood.size()), "rule");
    rule.text = "rule " + to_string(number);
    return rule;
}

CellRule totalistic_rule(const Integer& code, std::uint32_t states,
                         const std::vector<CellOffset>& neighbourhood) {
    CellRule rule = blank(states, neighbourhood);
    const std::size_t cells = neighbourhood.size(), size = cell_table_size(states, cells);
    const auto by_sum = digits(code, states, cells * (states - 1) + 1, "code");
    for (std::size_t number = 0; number < size; ++number) {
        std::size_t sum = 0;
        for (const std::uint8_t state : configuration(number, states, cells)) sum += state;
        rule.table.push_back(by_sum[sum]);
    }
    rule.text = "code " + to_string(code);
    return rule;
}

CellRule life_rule(std::string_view text, const std::vector<CellOffset>& neighbourhood) {
    CellRule rule = blank(2, neighbourhood);
    const std::size_t cells = neighbourhood.size(), slash = text.find('/');
    const auto counts = [&](std::string_view part, char first) {
        std::vector<bool> found(cells);
        const bool right = !part.empty() && (part.front() == first || part.front() == first + 32);
        for (const char digit : part.substr(right ? 1 : 0))
            if (!right || digit < '0' || digit > '9' ||
                static_cast<std::size_t>(digit - '0') >= cells)
                throw Error("expected a rule such as B3/S23 with numbers of neighbours from 0 to " +
                            std::to_string(cells - 1) + ", found '" + std::string(text) + "'");
            else
                found[static_cast<std::size_t>(digit - '0')] = true;
        if (!right)
            throw Error("expected a rule such as B3/S23, found '" + std::string(text) + "'");
        return found;
    };
    const auto born = counts(text.substr(0, slash), 'B');
    const auto survives =
        counts(slash == std::string_view::npos ? std::string_view() : text.substr(slash + 1), 'S');
    const auto own = static_cast<std::size_t>(
        std::find(neighbourhood.begin(), neighbourhood.end(), CellOffset{}) -
        neighbourhood.begin());
    for (std::size_t number = 0; number < cell_table_size(2, cells); ++number) {
        const auto local = configuration(number, 2, cells);
        const auto living = static_cast<std::size_t>(std::count(local.begin(), local.end(), 1));
        rule.table.push_back(local[own] ? survives[living - 1] : born[living]);
    }
    rule.text = text;
    return rule;
}

}  // namespace algae
