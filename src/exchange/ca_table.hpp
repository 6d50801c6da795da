#pragma once

#include <string>
#include <string_view>

#include "nature/relative.hpp"
#include "notation/relative_file.hpp"

namespace algae {

/// The table of a rule of cells on a line as a file of the kind `ca`: entries
///
///     000 -> 0    100 -> 1
///
/// or two lines, local configurations and below each its next state:
///
///     111 110 101 100 011 010 001 000
///      0   1   1   0   1   1   1   0
///
/// Arrows may be `→` or those of LaTeX, `\underline` and the separators of tables are passed over. The
/// number of states is one more than the greatest that occurs, the radius is that of the entries, of
/// which none may be missing. Throws Diagnostics with the place of the entry that is missing, given
/// twice or ill-formed.
RelativeFile read_ca_table(std::string_view text, const std::string& name);

/// The table of a CellularAutomaton, an entry a line. Its cells and what its figures show are not in
/// it. Throws Error if it lies in the plane.
std::string print_ca_table(const Relative& relative);

}  // namespace algae
