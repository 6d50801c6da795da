#pragma once

#include <string_view>

#include "notation/gallery.hpp"

namespace algae {

/// The name of the file of an entry.
///
/// Example: file_name({"fern", "figures/003-fractal-notes/fern.ifs", ""}) == "fern.ifs"
std::string_view file_name(const GalleryEntry& entry);

/// The file of another generator that comes with algae, by its name, `fern` or `fern.ifs`; nullptr
/// if there is none. Time linear in the number of entries.
///
/// Example: find_relative("fern") == find_relative("fern.ifs")
/// Example: find_relative("fern.ca") == nullptr
const GalleryEntry* find_relative(std::string_view name);

}  // namespace algae
