#pragma once

#include <string>
#include <string_view>

#include "nature/relative.hpp"
#include "notation/relative_file.hpp"

namespace algae {

/// A table of maps (x,y) -> (a x + b y + e, c x + d y + f), a row each, as a file of the kind `ifs`:
///
///     w     a     b     c     d     e     f     p
///     1     0     0     0  0.16     0     0  0.01
///     2  0.85  0.04 -0.04  0.85     0   1.6  0.85
///
/// Blanks, tabs, `|` and `&` separate columns, so that tables of Markdown and of LaTeX are read too. A
/// header names the columns in any order; without one they are in the order above, with or without
/// names and probabilities. Throws Diagnostics with the place of what is missing or given twice.
RelativeFile read_ifs_table(std::string_view text, const std::string& name);

/// The table of an IteratedFunctions. What its figures show is not in it. Throws Error if it has
/// several states.
std::string print_ifs_table(const Relative& relative);

}  // namespace algae
