#include "notation/relative_gallery.hpp"

#include <algorithm>

namespace algae {

std::string_view file_name(const GalleryEntry& entry) {
    return entry.path.substr(entry.path.find_last_of('/') + 1);
}

const GalleryEntry* find_relative(std::string_view name) {
    const auto entries = relative_gallery();
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const GalleryEntry& entry) {
        return entry.name == name || file_name(entry) == name;
    });
    return found == entries.end() ? nullptr : &*found;
}

}  // namespace algae
