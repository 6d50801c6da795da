#pragma once

#include <string>

#include "base/budget.hpp"
#include "system/lsystem.hpp"

namespace algae::cli {

/// What FILE means on the command line, in help texts.
inline constexpr const char* file_help = "a file, - for standard input, or a name from the gallery";

/// The type of such an argument.
inline constexpr const char* file_type = "FILE|NAME";

/// The bytes of a file. Throws Error if it cannot be read or is a folder, BoundReached if reading
/// it as a system would take more than the budget's memory.
std::string file_text(const std::string& path, const Budget& budget);

/// A text and what messages call it.
struct SourceText {
    std::string name, text;
};

/// The text of FILE: of a path, "-" for standard input, or a name from the gallery.
SourceText open_text(const std::string& file, const Budget& budget);

/// The system in FILE: a path, "-" for standard input, or a name from the gallery. Throws Error,
/// Diagnostics or BoundReached.
LSystem open_system(const std::string& file, const Budget& budget);

}  // namespace algae::cli
