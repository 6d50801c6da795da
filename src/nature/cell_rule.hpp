#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "exact/integer.hpp"

namespace algae {

/// A cell beside a cell: so many columns to the right and rows downward.
struct CellOffset {
    int column = 0, row = 0;
    bool operator==(const CellOffset&) const = default;
};

/// The rule of a cellular automaton: the states of a cell's neighbourhood decide its next state. The
/// neighbourhood has the cell itself in it; a local configuration is read as a number in base
/// `states`, its first cell the most significant digit, and `table` says the next state for each.
struct CellRule {
    std::uint32_t states = 2;
    int dimensions = 1;
    std::vector<CellOffset> neighbourhood;
    std::vector<std::uint8_t> table;
    std::string text;  // "rule 30", "B3/S23", as captions say

    /// The farthest offset in any direction.
    int radius() const;
    /// Whether it has two states, and a cell and its two neighbours decide.
    bool is_elementary() const;
    bool operator==(const CellRule&) const = default;
};

constexpr std::size_t largest_cell_table = std::size_t{1} << 24;

/// The cells at most `radius` away on a line, from left to right.
std::vector<CellOffset> line_neighbourhood(int radius);
/// Rows of the square of cells at most `radius` away in columns and rows (Moore).
std::vector<CellOffset> moore_neighbourhood(int radius);
/// The cells at most `radius` steps away (von Neumann).
std::vector<CellOffset> neumann_neighbourhood(int radius);

/// The rule of a number, as Wolfram counts them: its digits in base `states`, from the last, are the
/// table. Elementary rules are those of 2 states and radius 1.
///
/// Throws Error if the number is not below states^(states^cells), with the largest that is.
///
/// Example: numbered_rule(Integer(54), 2, line_neighbourhood(1)).table == std::vector<std::uint8_t>{0, 1, 1, 0, 1, 1, 0, 0}
CellRule numbered_rule(const Integer& number, std::uint32_t states,
                       const std::vector<CellOffset>& neighbourhood);

/// The rule that goes by the sum of the states of the neighbourhood alone: digit s of the code, in base
/// `states`, is the next state for the sum s.
CellRule totalistic_rule(const Integer& code, std::uint32_t states,
                         const std::vector<CellOffset>& neighbourhood);

/// The outer-totalistic rule `B3/S23` of two states: a dead cell comes to life with a number of living
/// neighbours behind B, a living one stays so with one behind S; both single digits.
///
/// Throws Error if the text has another form, or names more neighbours than there are.
CellRule life_rule(std::string_view text, const std::vector<CellOffset>& neighbourhood);

/// The number of entries of a table. Throws Error if there are more than 2^24.
std::size_t cell_table_size(std::uint32_t states, std::size_t neighbours);

}  // namespace algae
