#pragma once

#include <string>
#include <string_view>

#include "system/lsystem.hpp"

namespace algae {

/// The system of a Maple worksheet with one call `Lsystem(...)` and what is assigned before it:
///
/// - `Lsystem(AXIOMA, REGRAS, INCREMENTO, N)`: a string, a flat list of predecessors and successors,
///   the angle in degrees and the generation;
/// - `Lsystem(AXIOMA, REGRAS, PROB, INCREMENTO, N)`: the same with the probabilities of the rules,
///   which have one predecessor; percentages or fractions. The turtle starts upward;
/// - `Lsystem(AXIOMA, N)`: modules `["A",[1,10]]`, whose rules are functions `A := L -> [...]`.
///
/// Throws Diagnostics with the place of what is wrong.
///
/// Example: read_maple("Lsystem(\"F\", [\"F\",\"F+F\"], 60, 3);", "").rules.size() == 1
LSystem read_maple(std::string_view text, const std::string& name);

/// The worksheet of a system. What figures look like (colours, camera, widths of lines) and what is
/// expected of them is not in it, nor all generations but the last. Throws Error that names what a
/// worksheet cannot say: contexts, conditions, tables, probabilities of several predecessors, rules
/// for lower-case letters with parameters, and settings that change the figure.
///
/// Example: print_maple(read_lsystem("axiom F", "")) == "Lsystem(\"F\", [], 90, N);\n"
std::string print_maple(const LSystem& system);

}  // namespace algae
