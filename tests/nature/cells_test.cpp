#include "nature/detail/cells.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exact/exact.hpp"
#include "exchange/exchange.hpp"
#include "model/model.hpp"
#include "nature/nature.hpp"
#include "notation/notation.hpp"
#include "oracle/cells.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

CellularAutomaton automaton(const std::string& text) {
    return dynamic_cast<const CellularAutomaton&>(*read_generator(text, "cells.ca"));
}

std::string message(const std::string& text) {
    try {
        automaton(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

oracle::Rows rows_of(const CellGrid& grid) {
    oracle::Rows rows(grid.rows);
    for (std::size_t y = 0; y < grid.rows; ++y)
        for (std::size_t x = 0; x < grid.columns; ++x) rows[y].push_back(grid.at(x, y));
    return rows;
}

std::vector<std::pair<int, int>> steps(const CellRule& rule) {
    std::vector<std::pair<int, int>> found;
    for (const CellOffset& offset : rule.neighbourhood)
        found.emplace_back(offset.column, offset.row);
    return found;
}

CellGrid any_grid(std::size_t columns, std::size_t rows, std::uint32_t states) {
    CellGrid grid(columns, rows, Budget());
    for (std::uint8_t& cell : grid.cells)
        cell = static_cast<std::uint8_t>(*rc::gen::inRange<int>(0, static_cast<int>(states)));
    return grid;
}

CellBoundary any_boundary(std::uint32_t states) {
    CellBoundary boundary;
    boundary.periodic = *rc::gen::arbitrary<bool>();
    boundary.outside =
        static_cast<std::uint8_t>(*rc::gen::inRange<int>(0, static_cast<int>(states)));
    return boundary;
}

/// Some generations by both routes.
void check_steps(const CellRule& rule, const CellGrid& start, const CellBoundary& boundary,
                 const oracle::Next& next) {
    CellDevelopment development(rule, start, boundary);
    oracle::Rows rows = rows_of(start);
    for (int n = 0; n < 5; ++n) {
        development.step(1, {});
        rows =
            oracle::next_cells(rows, steps(rule), next, boundary.periodic ? -1 : boundary.outside);
        RC_ASSERT(rows_of(development.grid()) == rows);
    }
}

std::vector<std::size_t> alive(const std::string& text, std::uint64_t last) {
    std::vector<std::size_t> counts;
    const CellularAutomaton cells = automaton(text);
    for (std::uint64_t n = 0; n <= last; ++n) {
        std::size_t count = 0;
        for (const std::uint8_t cell : cells.generation(n, {}).cells) count += cell != 0;
        counts.push_back(count);
    }
    return counts;
}

}  // namespace

TEST_CASE("rules 54 and 126 from one cell have the counts of their pictures") {
    CHECK(alive("rule 54", 8) == std::vector<std::size_t>{1, 3, 2, 6, 3, 9, 4, 12, 5});
    CHECK(alive("rule 126", 8) == std::vector<std::size_t>{1, 3, 4, 7, 4, 8, 8, 15, 4});
    CHECK(alive("table 000->0 001->1 010->1 011->0 100->1 101->1 110->0 111->0", 8) ==
          alive("rule 54", 8));
    CHECK(automaton("table 000->0 001->1 010->1 011->1 100->1 101->1 110->1 111->0").rule.text ==
          "rule 126");
}

TEST_CASE("elementary rules on 64 cells at a time are the rule on each cell") {
    CHECK(rc::check([] {
        const int number = *rc::gen::inRange(0, 256);
        const CellRule rule = numbered_rule(Integer(number), 2, line_neighbourhood(1));
        const auto columns = static_cast<std::size_t>(*rc::gen::inRange(1, 200));
        check_steps(rule, any_grid(columns, 1, 2), any_boundary(2),
                    [&](const std::vector<int>& seen) {
                        return number >> (4 * seen[0] + 2 * seen[1] + seen[2]) & 1;
                    });
    }));
}

TEST_CASE("rules of several states, of wider neighbourhoods and in the plane") {
    CHECK(rc::check([] {
        const auto states = static_cast<std::uint32_t>(*rc::gen::inRange(2, 5));
        const int radius = *rc::gen::inRange(1, 3);
        const bool plane = *rc::gen::arbitrary<bool>();
        CellRule rule = numbered_rule(
            Integer(0), states, plane ? neumann_neighbourhood(1) : line_neighbourhood(radius));
        for (std::uint8_t& entry : rule.table)
            entry = static_cast<std::uint8_t>(*rc::gen::inRange<int>(0, static_cast<int>(states)));
        const auto columns = static_cast<std::size_t>(*rc::gen::inRange(1, 20));
        const auto rows = static_cast<std::size_t>(plane ? *rc::gen::inRange(1, 8) : 1);
        check_steps(rule, any_grid(columns, rows, states), any_boundary(states),
                    [&](const std::vector<int>& seen) {
                        std::size_t place = 0;
                        for (const int state : seen)
                            place = place * states + static_cast<std::size_t>(state);
                        return static_cast<int>(rule.table[place]);
                    });
    }));
}

TEST_CASE("Life goes by numbers of neighbours, and a glider glides") {
    CHECK(rc::check([] {
        const CellRule rule = life_rule("B3/S23", moore_neighbourhood(1));
        check_steps(rule, any_grid(9, 7, 2), any_boundary(2), [](const std::vector<int>& seen) {
            int living = 0;
            for (std::size_t i = 0; i < seen.size(); ++i) living += i == 4 ? 0 : seen[i];
            return living == 3 || (living == 2 && seen[4] == 1) ? 1 : 0;
        });
    }));
    const CellularAutomaton glider =
        automaton("life B3/S23\ncells 8 8\nrow .O.\nrow ..O\nrow OOO\n");
    CellGrid moved(8, 8, Budget());
    for (std::size_t y = 0; y < 8; ++y)
        for (std::size_t x = 0; x < 8; ++x)
            moved.at((x + 1) % 8, (y + 1) % 8) = glider.start.at(x, y);
    CHECK(glider.generation(4, {}) == moved);
}

TEST_CASE("a table has an entry for each state of the neighbourhood, the cell itself included") {
    for (const std::uint32_t states : {2u, 3u})
        for (const int radius : {1, 2}) {
            std::size_t size = 1;
            for (int i = 0; i < 2 * radius + 1; ++i) size *= states;
            CHECK(numbered_rule(Integer(1), states, line_neighbourhood(radius)).table.size() ==
                  size);
        }
    // Wolfram's totalistic code 777 of three states: sums 0 to 6 become 0 1 2 1 0 0 1.
    const CellRule code = totalistic_rule(Integer(777), 3, line_neighbourhood(1));
    CHECK(code.table[0] == 0);
    CHECK(code.table[1] == 1);
    CHECK(code.table[2] == 2);
    CHECK(code.table[26] == 1);
}

TEST_CASE(
    "an automaton between fixed states and its system with interactions agree for 1,000 steps") {
    for (const char* text :
         {"rule 110\ncells 90\nboundary fixed\nstart random\n",
          "rule 30\ncells 40\nboundary fixed 1\n", "rule 110\ncells 2\nboundary fixed 1\n",
          "rule 30\ncells 1\nboundary fixed 1\n"}) {
        const CellularAutomaton cells = automaton(text);
        const Model system = system_of_cells(cells);
        Development development(*as_il(system));
        CellDevelopment other(cells.rule, cells.start, cells.boundary);
        bool equal = true;
        for (int n = 0; n < 1000 && equal; ++n) {
            std::string word;
            for (const Symbol letter : development.word()) word += system.alphabet.name(letter);
            equal = word + "\n" == grid_text(other.grid());
            development.step();
            other.step(1, {});
        }
        INFO(text);
        CHECK(equal);
    }
    CHECK(rc::check([] {
        CellularAutomaton cells;
        const auto states = static_cast<std::uint32_t>(*rc::gen::inRange(2, 4));
        cells.rule = numbered_rule(Integer(0), states, line_neighbourhood(*rc::gen::inRange(1, 3)));
        for (std::uint8_t& entry : cells.rule.table)
            entry = static_cast<std::uint8_t>(*rc::gen::inRange<int>(0, static_cast<int>(states)));
        cells.boundary = any_boundary(states);
        cells.boundary.periodic = false;
        cells.start = any_grid(static_cast<std::size_t>(*rc::gen::inRange(1, 12)), 1, states);
        const Model system = system_of_cells(cells);
        Development development(*as_il(system));
        for (std::uint64_t n = 0; n < 6; ++n) {
            std::string word;
            for (const Symbol letter : development.word()) word += system.alphabet.name(letter);
            RC_ASSERT(word + "\n" == grid_text(cells.generation(n, {})));
            development.step();
        }
    }));
}

TEST_CASE("what is wrong with a file of cells") {
    CHECK(message("rule 256") ==
          "cells.ca:1:6: error: the rule 256 is out of range: expected 0 to 255\n  rule 256\n      "
          " ^");
    CHECK(message("rule -1") ==
          "cells.ca:1:6: error: expected a whole number of at least 0, found '-1'\n  rule -1\n     "
          "  ^");
    CHECK(message("cells 5") ==
          "cells.ca: has no rule; expected a line such as `rule 30`, `life B3/S23`, `code 10` or "
          "`table 000->0 ...`");
    CHECK(
        message("life B9/S23") ==
        "cells.ca:1:6: error: expected a rule such as B3/S23 with numbers of neighbours from 0 to "
        "8, found 'B9/S23'\n  life B9/S23\n       ^");
    CHECK(message("rule 30\ncells 900000000000") ==
          "a grid of 900000000000 x 1 cells does not fit in the 4096 MiB allowed");
    CHECK(message("rule 30\ncells 0") ==
          "cells.ca:2:7: error: expected cells with a whole number from 1 to 1099511627776, found "
          "'0'\n"
          "  cells 0\n        ^");
    CHECK(message("rule 30\nstart 012") ==
          "cells.ca:2:7: error: expected states from 0 to 1, or . and O for 0 and 1, found '2'\n"
          "  start 012\n        ^");
    // It crashed once: no `cells` line is to blame.
    CHECK(message("rule 110\nrow ..O\nrow OOO") ==
          "cells.ca: has several `row` lines; a rule on a line starts from one");
    CHECK_THROWS_WITH_AS(
        system_of_cells(automaton("rule 30")),
        "cells.ca: its edges are joined, and no context of a word reaches from its "
        "end to its beginning; expected `boundary fixed 0` or another state",
        Error);
}
