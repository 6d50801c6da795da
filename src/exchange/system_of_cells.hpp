#pragma once

#include "nature/cellular_automaton.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// A cellular automaton on a line between fixed states as a system with interactions whose words are
/// its configurations: a rule for each local configuration, and near the ends, where a word has no
/// letters for the context, rules with shorter contexts that take the state outside for them. Of the
/// rules that match, the longest context wins, so each letter has exactly one.
///
/// Throws Error if the edges are joined, which no context reaches over, if there are two dimensions,
/// or if there would be more than 20,000 rules.
LSystem system_of_cells(const CellularAutomaton& automaton);

}  // namespace algae
