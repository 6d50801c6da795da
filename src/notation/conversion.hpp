#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/budget.hpp"
#include "nature/cellular_automaton.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// A way from one text format to another: what the end of a file's name says, and what is made of it.
struct Conversion {
    std::string from, to;
    std::string what;  // "the graph-directed system of a curve"
    /// The text of the other file. Throws Diagnostics or Error with the reason where there is none.
    std::string (*convert)(std::string_view text, const std::string& name, const Budget& budget);
};

/// All conversions that there are.
const std::vector<Conversion>& conversions();

/// The text in another format.
///
/// Throws Error, with the formats that there are, if there is no such conversion.
std::string converted(std::string_view text, const std::string& name, const std::string& from,
                      const std::string& to, const Budget& budget);

/// A cellular automaton on a line between fixed states as a system with interactions whose words are
/// its configurations: a rule for each local configuration, and near the ends, where a word has no
/// letters for the context, rules with shorter contexts that take the state outside for them. Of the
/// rules that match, the longest context wins, so each letter has exactly one.
///
/// Throws Error if the edges are joined, which no context reaches over, if there are two dimensions,
/// or if there would be more than 20,000 rules.
LSystem system_of_cells(const CellularAutomaton& automaton);

}  // namespace algae
