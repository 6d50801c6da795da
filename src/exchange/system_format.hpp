#pragma once
// exchange: files of other programs, read and written, and one kind of file turned into another.

#include <string>
#include <string_view>
#include <vector>

#include "system/lsystem.hpp"

namespace algae {

/// A text format in which another program keeps L-systems.
struct SystemFormat {
    std::string name;  // the end of its files' names, without the point: "brno"
    std::string what;  // "a text file of the geometric interpreter"
    /// The system that the text says; `name` is what errors call the file. Throws `Diagnostics` with
    /// every fault it can name.
    LSystem (*read)(std::string_view text, const std::string& name);
    /// The text of a system; it reads back as a system with the same words and figures. Throws Error
    /// that names what the format cannot say.
    std::string (*print)(const LSystem& system);
};

/// All of them.
const std::vector<SystemFormat>& system_formats();

/// The format whose files end as this name does; nullptr if there is none.
///
/// Example: system_format("koch.lsys") == nullptr
const SystemFormat* system_format(std::string_view file_name);

}  // namespace algae
