#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nature/cells.hpp"
#include "nature/relative.hpp"

namespace algae {

/// A cellular automaton with the configuration that it starts from: cells on a line or in the plane,
/// all of which take their next state at once, by one rule, from the states of their neighbourhoods.
class CellularAutomaton : public Relative {
public:
    CellRule rule;
    CellBoundary boundary;
    CellGrid start;
    /// On a line the first and the last one shown, below each other; in the plane one picture each.
    std::vector<std::uint64_t> generations{0, 50};
    /// Whether the rule's table stands above the picture.
    bool legend = false;

    std::vector<RelativeFigure> figures(const Budget& budget) const override;
    /// The rule, the grid, and how many cells are not 0 in the first generations.
    std::vector<RelativeFact> facts(const Budget& budget) const override;

    /// Generation `first` and those after it up to `last`, one row each. On a line only. Throws Error
    /// if they do not fit in memory.
    CellGrid space_time(std::uint64_t first, std::uint64_t last, const Budget& budget) const;
    /// The configuration of a generation.
    CellGrid generation(std::uint64_t n, const Budget& budget) const;
};

/// The character of a state: 0 to 9, then a to z. At most 36 states have one.
///
/// Example: state_character(11) == 'b'
char state_character(std::uint8_t state);

/// The rows of a grid, a character for each cell, with a line break behind each.
std::string grid_text(const CellGrid& grid);

}  // namespace algae
