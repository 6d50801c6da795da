#include "render/mesh_format.hpp"

#include <algorithm>
#include <array>

namespace algae {

namespace {

constexpr std::array names{"glb", "obj", "ply", "stl", "x3d", "wrl", "vrml1"};

}  // namespace

std::optional<MeshFormat> mesh_format(std::string_view path) {
    std::string end(path.substr(path.rfind('.') == path.npos ? path.size() : path.rfind('.') + 1));
    std::transform(end.begin(), end.end(), end.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    for (std::size_t i = 0; i < names.size(); ++i)
        if (end == names[i]) return static_cast<MeshFormat>(i);
    return std::nullopt;
}

const char* mesh_format_name(MeshFormat format) { return names[static_cast<std::size_t>(format)]; }

std::string mesh_format_names() {
    std::string all = names[0];
    for (std::size_t i = 1; i < names.size(); ++i)
        all += (i + 1 == names.size() ? " or " : ", ") + std::string(names[i]);
    return all;
}

}  // namespace algae
