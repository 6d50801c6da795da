#pragma once

#include <string>
#include <vector>

#include "base/budget.hpp"
#include "render/mesh_format.hpp"
#include "space/mesh.hpp"
#include "system/settings.hpp"

namespace algae {

/// The bytes of files.
struct MeshFiles {
    std::string main;
    std::string materials;  // of an obj
};

/// A mesh as a file of glb, obj, ply or stl. `colours` has one for each of the mesh's paints. `name`
/// is that of the file of materials of an obj; empty: there is none. `upright`: z is up and becomes y
/// in formats that say that y is up.
///
/// Throws Error if the library that writes them fails, BoundReached if it needs more memory than the
/// budget has.
MeshFiles mesh_files(const Mesh& mesh, const std::vector<Colour>& colours, MeshFormat format,
                     const std::string& name, bool upright, const Budget& budget);

}  // namespace algae
