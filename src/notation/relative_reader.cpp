#include "notation/relative_reader.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "notation/boxes_file.hpp"
#include "notation/brownian_file.hpp"
#include "notation/ca_file.hpp"
#include "notation/dla_file.hpp"
#include "notation/function_file.hpp"
#include "notation/ifs_file.hpp"
#include "notation/particles_file.hpp"
#include "notation/terrain_file.hpp"
#include "notation/walk_file.hpp"

namespace algae {

namespace {

const RelativeKind& kind_of(const std::string& file_name) {
    if (const RelativeKind* kind = relative_kind(file_name)) return *kind;
    std::string endings;
    for (const RelativeKind& kind : relative_kinds())
        endings += (endings.empty() ? "." : ", .") + kind.ending;
    throw Error("expected a file ending in " + endings + ", found \"" + file_name + "\"");
}

}  // namespace

const std::vector<RelativeKind>& relative_kinds() {
    static const std::vector<RelativeKind> kinds{ifs_kind(),       ca_kind(),       walk_kind(),
                                                 brownian_kind(),  terrain_kind(),  dla_kind(),
                                                 particles_kind(), function_kind(), boxes_kind()};
    return kinds;
}

const RelativeKind* relative_kind(std::string_view file_name) {
    const auto& kinds = relative_kinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const RelativeKind& kind) {
        return file_name.ends_with("." + kind.ending);
    });
    return found == kinds.end() ? nullptr : &*found;
}

std::unique_ptr<Relative> read_relative(std::string_view text, const std::string& file_name) {
    const RelativeKind& kind = kind_of(file_name);
    return kind.make(read_relative_file(text, file_name, kind.keys));
}

std::string format_relative(std::string_view text, const std::string& file_name) {
    const RelativeKind& kind = kind_of(file_name);
    const RelativeFile file = read_relative_file(text, file_name, kind.keys);
    kind.make(file);
    return print_relative_file(file);
}

}  // namespace algae
