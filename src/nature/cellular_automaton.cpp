#include "nature/cellular_automaton.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "nature/cell_figure.hpp"

namespace algae {

namespace {

/// The table of a rule on a line above a picture as wide as `columns`: each local configuration over
/// the state that follows it, from the one of the highest number to that of 0 (as the digits of the
/// rule's number are written).
std::vector<Path> table_paths(const CellRule& rule, double columns) {
    const std::size_t cells = rule.neighbourhood.size(), entries = rule.table.size();
    const double gap = 1, entry = static_cast<double>(cells) + gap;
    const double scale = columns / (static_cast<double>(entries) * entry - gap);
    const double low = 2;  // free rows of the picture between it and the table
    std::vector<Path> filled, frames;
    const auto cell = [&](double column, double row, std::uint8_t state) {
        const double x = column * scale, y = low + row * scale;
        const std::vector<Point> corners{
            {x, y}, {x + scale, y}, {x + scale, y + scale}, {x, y + scale}};
        if (state != 0) filled.push_back({corners, state - 1u, true});
        frames.push_back({corners, 0, false});
        frames.back().points.push_back(corners.front());
    };
    for (std::size_t i = 0; i < entries; ++i) {
        std::size_t number = entries - 1 - i;
        const double left = static_cast<double>(i) * entry;
        cell(left + (static_cast<double>(cells) - 1) / 2, 0, rule.table[number]);
        for (std::size_t k = cells; k-- > 0; number /= rule.states)
            cell(left + static_cast<double>(k), 1.5,
                 static_cast<std::uint8_t>(number % rule.states));
    }
    filled.insert(filled.end(), frames.begin(), frames.end());
    return filled;
}

Settings with_colours(Settings settings, std::uint32_t states) {
    if (settings.colours.empty() && states > 2)
        settings.colours = {"black",    "firebrick", "steelblue", "goldenrod",
                            "seagreen", "orchid",    "sienna",    "grey"};
    return settings;
}

std::size_t alive(const CellGrid& grid) {
    return grid.cells.size() -
           static_cast<std::size_t>(std::count(grid.cells.begin(), grid.cells.end(), 0));
}

}  // namespace

CellGrid CellularAutomaton::space_time(std::uint64_t first, std::uint64_t last,
                                       const Budget& budget) const {
    CellGrid all(start.columns, last - first + 1, budget);
    CellDevelopment development(rule, start, boundary);
    development.step(first, budget);
    for (std::uint64_t n = first; n <= last; ++n) {
        const CellGrid row = development.grid();
        std::copy(row.cells.begin(), row.cells.end(),
                  all.cells.begin() + static_cast<std::ptrdiff_t>((n - first) * start.columns));
        if (n < last) development.step(1, budget);
    }
    return all;
}

CellGrid CellularAutomaton::generation(std::uint64_t n, const Budget& budget) const {
    CellDevelopment development(rule, start, boundary);
    development.step(n, budget);
    return development.grid();
}

std::vector<RelativeFigure> CellularAutomaton::figures(const Budget& budget) const {
    const std::string what = title.empty() ? rule.text : title;
    const Settings own = with_colours(settings, rule.states);
    std::vector<RelativeFigure> found;
    if (rule.dimensions == 1) {
        CellGrid all = space_time(generations.front(), generations.back(), budget);
        std::vector<Path> table;
        if (legend) table = table_paths(rule, static_cast<double>(all.columns));
        found.push_back(
            {std::make_unique<CellFigure>(std::move(all), std::move(table), own), what, what});
        return found;
    }
    CellDevelopment development(rule, start, boundary);
    std::uint64_t now = 0;
    for (const std::uint64_t n : generations) {
        development.step(n - now, budget);
        now = n;
        found.push_back({std::make_unique<CellFigure>(development.grid(), std::vector<Path>(), own),
                         what + ", generation " + std::to_string(n), "n = " + std::to_string(n)});
    }
    return found;
}

std::vector<RelativeFact> CellularAutomaton::facts(const Budget& budget) const {
    constexpr std::uint64_t most_counted = 1000, most_listed = 16;
    constexpr std::size_t most_shown = 32;
    std::vector<RelativeFact> found;
    found.push_back({"rule", rule.text, rule.text});
    if (rule.dimensions == 1 && rule.table.size() <= most_shown) {
        std::string text;
        nlohmann::ordered_json table;
        for (std::size_t number = 0; number < rule.table.size(); ++number) {
            std::string local;
            std::size_t rest = number;
            for (std::size_t i = 0; i < rule.neighbourhood.size(); ++i, rest /= rule.states)
                local += state_character(static_cast<std::uint8_t>(rest % rule.states));
            std::reverse(local.begin(), local.end());
            text += (text.empty() ? "" : " ") + local + "->" + state_character(rule.table[number]);
            table[local] = rule.table[number];
        }
        found.push_back({"table", text, table});
    }
    found.push_back({"states", std::to_string(rule.states), rule.states});
    std::string cells = std::to_string(start.columns);
    if (rule.dimensions == 2) cells += " x " + std::to_string(start.rows);
    found.push_back({"cells",
                     cells + (boundary.periodic ? ", edges joined" : ""),
                     {start.columns, start.rows}});
    std::string counts;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    CellDevelopment development(rule, start, boundary);
    const std::uint64_t last = std::min(generations.back(), most_counted);
    for (std::uint64_t n = 0; n <= last; ++n) {
        const std::size_t count = alive(development.grid());
        all.push_back(count);
        if (n <= most_listed) counts += (n ? ", " : "") + std::to_string(count);
        if (n < last) development.step(1, budget);
    }
    found.push_back({"cells_alive", counts + (last > most_listed ? ", ..." : ""), all});
    return found;
}

char state_character(std::uint8_t state) {
    return static_cast<char>(state < 10 ? '0' + state : 'a' + (state - 10));
}

std::string grid_text(const CellGrid& grid) {
    std::string text;
    for (std::size_t row = 0; row < grid.rows; ++row) {
        for (std::size_t x = 0; x < grid.columns; ++x) text += state_character(grid.at(x, row));
        text += '\n';
    }
    return text;
}

}  // namespace algae
