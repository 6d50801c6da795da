#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace algae {

/// Files of figures in space that other programs open.
enum class MeshFormat {
    glb,    // glTF 2.0, binary
    obj,    // Wavefront, with a file of materials beside
    ply,    // Stanford, binary
    stl,    // binary
    x3d,    // X3D 3.3 as XML
    wrl,    // VRML97
    vrml1,  // VRML 1.0
};

/// The format that the end of a file's name stands for, in any case, or nothing.
///
/// Example: mesh_format("trees/honda.GLB") == MeshFormat::glb
/// Example: !mesh_format("koch.svg")
std::optional<MeshFormat> mesh_format(std::string_view path);

/// The name of the format, which is also how a file of it ends, except for `vrml1`.
///
/// Example: mesh_format_name(MeshFormat::wrl) == std::string("wrl")
const char* mesh_format_name(MeshFormat format);

/// The names of all: "glb, obj, ply, stl, x3d, wrl or vrml1".
std::string mesh_format_names();

}  // namespace algae
