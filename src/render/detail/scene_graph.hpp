#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "render/render.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"

namespace algae {

/// A turn about an axis, as scene graphs write it.
struct AxisTurn {
    Vector axis{0, 0, 1};
    double radians = 0;
};

/// The turn that takes the axes x, y and z to these, which are orthonormal and right-handed.
AxisTurn turn_to(const Vector& x, const Vector& y, const Vector& z);

/// A scene as VRML and X3D describe one: y is up unless the figure is one of the plane.
///
/// Solids, and rods on their own that end flat, are nodes of their own kind, each with its absolute place:
/// no transformation is inherited from another. (Up to 20,000 of them; then all rods are surfaces.)
/// Other rods are surfaces of tubes, a set for each colour; polygons too. Lines without thickness are
/// polylines.
struct SceneGraph {
    struct Body {
        SolidShape shape = SolidShape::box;
        Vector middle;
        AxisTurn turn;
        Vector
            size;  // box: along its x, y, z; otherwise .x is the radius and .y the height along y
        std::uint32_t colour = 0;
    };
    struct Surface {
        std::vector<Vector> points;
        std::vector<Mesh::Triangle> triangles;  // in points
        bool sheet = false;                     // to be seen from both sides
        std::uint32_t colour = 0;
    };
    struct Lines {
        std::vector<Vector> points;
        std::vector<std::uint32_t> strokes;  // how many points each stroke has, in order
        std::uint32_t colour = 0;
    };
    struct Viewpoint {
        std::string name;
        Vector place;
        AxisTurn turn;         // of a camera that looks along -z with y upward
        double distance = 1;   // to what it looks at
        double opening = 0.7;  // radians, of the smaller side of the picture
    };

    std::vector<Colour> colours;
    std::vector<Body> bodies;
    std::vector<Surface> surfaces;
    std::vector<Lines> lines;
    std::vector<Viewpoint> viewpoints;  // the first is where a viewer begins
    Vector light;                       // the way it shines, of length 1
    Colour background{1, 1, 1};
    std::string title;
    double crease = 0.7;   // radians
    bool upright = false;  // a figure in space, which may stand on a ground
    std::uint64_t vertices = 0, triangles = 0, strokes = 0;
    SpaceBox box;  // in the units and axes of the scene
};

/// The graph of a scene whose paints are all colours of their own. The camera is the first viewpoint
/// of a figure in space; one of the plane is looked at from straight in front. Without a light it comes over the left shoulder of the
/// first viewpoint. Throws what mesh_of throws. O(parts) time.
SceneGraph scene_graph(const Scene& scene, const MeshOptions& options, const Camera& camera,
                       const std::optional<Light>& light, const Budget& budget);

/// Whether something lies outside the plane z = 0.
bool is_in_space(const SpaceBox& box);

/// Writes a scene graph as VRML97 (ISO/IEC 14772-1:1997). Throws Error if the bytes cannot be written.
void write_vrml97(const SceneGraph& graph, Output& output, const Budget& budget);

/// The same as VRML 1.0 (Bell, Parisi and Pesce, The Virtual Reality Modeling Language, version 1.0,
/// 1995). Each shape stands in a Separator of its own with its absolute place: a Separator around each
/// module's movements alone would undo them at its end.
void write_vrml1(const SceneGraph& graph, Output& output, const Budget& budget);

/// Writes a scene graph as X3D 3.3 in XML (ISO/IEC 19776-1), profile Interchange. Throws Error if the
/// bytes cannot be written.
void write_x3d(const SceneGraph& graph, Output& output, const Budget& budget);

/// Writes a scene graph as a scene for POV-Ray 3.7. Surfaces are smooth but for creases. Throws Error if the bytes cannot be written.
void write_pov(const SceneGraph& graph, Output& output, const Budget& budget);

}  // namespace algae
