#pragma once

#include <string>
#include <string_view>

#include "system/lsystem.hpp"

namespace algae {

/// The system in a text file of a geometric interpreter of D0L systems (Brno, 2008): sections
/// `modules:`, `axiom:`, `angles:`, `rules:`, then `END` and notes.
///
/// Modules are letters, each with a primitive that overrides the turtle's own meaning of it: a
/// cylinder `C(diameter, height)`, a line `P(length)`, a ball `S(diameter)`; those without one do
/// nothing. `+ -` turn by the angle U, `& ^` by L, `\ /` by H. Throws `Diagnostics` with everything
/// that is wrong. Linear time.
LSystem read_brno(std::string_view text, const std::string& name);

/// The file of a system. Throws Error that names what no file can say: it has single letters, one
/// rule for each, whole angles, whole lengths above 0, and no turtle that starts elsewhere than at
/// the origin and looks along x. Titles stand in a comment; colours, cameras, line widths and what
/// is expected are left out.
std::string print_brno(const LSystem& system);

}  // namespace algae
