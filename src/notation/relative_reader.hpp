#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "nature/relative.hpp"
#include "notation/relative_file.hpp"

namespace algae {

/// A kind of relatives: how its files end, what stands in them, and how one is made of them.
struct RelativeKind {
    std::string ending;  // without the point: "ifs"
    std::string what;    // "an iterated function system"
    std::vector<RelativeKey> keys;
    /// Throws Diagnostics or Error where values are missing, out of range or do not fit together.
    std::unique_ptr<Relative> (*make)(const RelativeFile&);
};

/// All kinds that there are.
const std::vector<RelativeKind>& relative_kinds();

/// The kind whose files end as this name does; nullptr if it is no relative's.
///
/// Example: relative_kind("figures/koch.lsys") == nullptr
const RelativeKind* relative_kind(std::string_view file_name);

/// The relative that the text of a file says. Throws `Diagnostics` or Error.
std::unique_ptr<Relative> read_relative(std::string_view text, const std::string& file_name);

/// The canonical text of a relative's file, comments kept. Throws as `read_relative` does.
std::string format_relative(std::string_view text, const std::string& file_name);

}  // namespace algae
