#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "render/mesh_format.hpp"
#include "space/camera.hpp"
#include "space/mesh.hpp"

namespace algae {

/// How a scene is written.
struct MeshChoices {
    MeshOptions mesh;
    /// Instead of the scene's own list: names or `#rrggbb`. With neither, everything is gray.
    std::vector<std::string> colours;
    /// The first viewpoint of x3d, wrl and vrml1, always in perspective.
    Camera camera;
    /// Behind the scene in x3d, wrl and vrml1; nothing: white.
    std::optional<std::string> background;
};

/// What was written.
struct MeshDrawn {
    std::uint64_t vertices = 0;  // corners of triangles, several at a point where there is an edge
    std::uint64_t triangles = 0;
    std::uint64_t solids = 0;  // boxes, cylinders, cones and spheres as such
    std::uint64_t lines = 0;   // strokes without thickness as such
    SpaceBox box;              // in the units of the figure, with the thickness of its rods
};

/// Writes a scene to a file. It appears complete or not at all, and equal scenes make equal files,
/// byte for byte. An obj comes with a file of materials beside it, of the same name but `.mtl`.
///
/// A unit of the figure is a unit of the file (in glb a metre). Up is z in ply and stl; glb, obj, x3d,
/// wrl and vrml1 say that up is y: there (x, y, z) becomes (x, z, -y), so that a tree stands. A figure
/// of the plane keeps x and y and faces the reader. Colours are a material each in glb and obj, of
/// the vertices in ply, and missing in stl. x3d, wrl and vrml1 hold a scene graph (see SceneGraph).
///
/// Throws what mesh_of throws, Error on an unknown colour or a file that cannot be written,
/// BoundReached if writing takes more memory than the budget has: all before a file appears.
MeshDrawn draw_mesh(const Scene& scene, const std::string& path, MeshFormat format,
                    const MeshChoices& choices, const Budget& budget);
/// The same to a stream; an obj is without materials then.
MeshDrawn draw_mesh(const Scene& scene, std::ostream& stream, MeshFormat format,
                    const MeshChoices& choices, const Budget& budget);

}  // namespace algae
