#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nature/relative.hpp"
#include "notation/relative_file.hpp"

namespace algae {

/// A printed form of a kind of relatives, such as the table of an iterated function system.
struct RelativeFormat {
    std::string name;  // the end of its files' names, without the point: "ifs-table"
    std::string kind;  // that of the files of the notation which say the same: "ifs"
    std::string what;  // "the table of an iterated function system"
    /// What the text says as a file of the kind, its places those of the text. Throws Diagnostics.
    RelativeFile (*read)(std::string_view text, const std::string& name);
    /// The text of a relative of the kind. Throws Error that names what it cannot say.
    std::string (*print)(const Relative& relative);
};

/// All of them.
const std::vector<RelativeFormat>& relative_formats();

/// The format whose files end as this name does; nullptr if there is none.
///
/// Example: relative_format("fern.ifs") == nullptr
const RelativeFormat* relative_format(std::string_view file_name);

}  // namespace algae
