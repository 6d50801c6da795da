#pragma once

#include <string>
#include <string_view>

#include "system/lsystem.hpp"

namespace algae {

/// The system in a setup procedure of a NetLogo model of L-systems, or in a settings file of the
/// same lines: `add-rule "F" "F-F+F" "F"` with letter, successor and command, `set chain "F"` and so on.
///
/// Commands are F, f, +, -, [ and ] as the turtle's own, * where `k` is set, S a stamp; all else is
/// ignored. Of several rules for a letter one is chosen at random, all equally likely. Headings
/// are 0 in the north and grow clockwise; k-shorten and d-delta change d and delta-0 from one
/// generation to the next. Throws `Diagnostics` with everything that is wrong. Linear time.
LSystem read_netlogo(std::string_view text, const std::string& name);

/// The body of a setup procedure that says a system. Throws Error that names what no such procedure
/// can say: symbols longer than a character, contexts, parameters, tables, polygons, figures in
/// space, stamps other than squares, probabilities with denominators above 100. Titles stand in a comment;
/// colours, line widths and what is expected are left out.
std::string print_netlogo(const LSystem& system);

}  // namespace algae
