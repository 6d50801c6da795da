#pragma once

#include <string>
#include <string_view>

namespace algae {

/// The canonical text of a `.lsys` file with its comments: those above the first statement stay at
/// the top, those above or behind another statement go where it goes, and those whose statement
/// is not printed, or that stand below the last one, come at the end. Formatting twice is formatting
/// once. Throws `Diagnostics` as `read_lsystem` does.
///
/// Example: format_lsystem("angle 60 # degrees\naxiom F", "koch.lsys")
///     == "axiom F\nangle 60 # degrees\n"
std::string format_lsystem(std::string_view text, const std::string& file_name);

}  // namespace algae
