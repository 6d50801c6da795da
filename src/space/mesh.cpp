#include "space/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "space/limbs.hpp"
#include "space/mesh_builder.hpp"
#include "space/sheet_mesh.hpp"
#include "space/solid_mesh.hpp"
#include "space/tube_mesh.hpp"

namespace algae {

namespace {

bool finite(const Vector& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check(const Scene& scene, const MeshOptions& options) {
    if (options.facets < 3 || options.facets > 256)
        throw Error("a tube has 3 to 256 facets, found " + std::to_string(options.facets));
    if (!(options.crease >= 0 && options.crease <= 180))
        throw Error("a crease is an angle of 0 to 180 degrees");
    if (scene.empty()) throw Error(scene.name + " draws nothing");
    for (const Vector& corner : scene.corners)
        if (!finite(corner))
            throw Error(scene.name + " has a polygon that does not lie at finite coordinates");
    for (const Solid& solid : scene.solids)
        if (!finite(solid.middle) || !finite(solid.size))
            throw Error(scene.name + " has a solid whose place or measures are not finite");
}

/// Throws BoundReached if the mesh would be too large. The bound on its corners is exact up to shading.
TubeSize checked_size(const Scene& scene, const Limbs& limbs, const MeshOptions& options,
                      const Budget& budget) {
    TubeSize all;
    const auto add = [&](const TubeSize& size) {
        all.triangles += size.triangles;
        all.corners += size.corners;
        all.points += size.points;
    };
    for (const Limb& limb : limbs.limbs)
        if (options.cylinders || !is_cylinder(limbs, limb)) add(tube_size(limb, options.facets));
    if (options.solids)
        for (const Solid& solid : scene.solids) add(solid_size(solid.shape, 2 * options.facets));
    const std::uint64_t sheets = scene.corners.size();
    add({sheets, sheets, sheets});
    if (std::max(all.triangles * 3, all.corners) >= std::numeric_limits<std::uint32_t>::max())
        throw BoundReached(
            Bound::method,
            "the mesh of " + scene.name + " would have " + std::to_string(all.triangles) +
                " triangles, more than the 2^32 indices that files of meshes allow; use fewer "
                "facets or an earlier generation");
    const std::uint64_t bytes = all.triangles * sizeof(Mesh::Triangle) +
                                all.corners * sizeof(Mesh::Corner) + all.points * sizeof(Vector) +
                                sheets * 64;
    budget.check_memory(
        bytes, ("the mesh of " + scene.name + ", " + std::to_string(all.triangles) + " triangles,")
                   .c_str());
    return all;
}

}  // namespace

Mesh mesh_of(const Scene& scene, const MeshOptions& options, const Budget& budget) {
    check(scene, options);
    const Thickness thick = thickness(scene);
    const Limbs limbs = limbs_of(scene, thick, budget);
    const TubeSize size = checked_size(scene, limbs, options, budget);
    MeshBuilder builder(scene.colours.size());
    builder.mesh.points.reserve(size.points);
    builder.mesh.corners.reserve(size.corners);
    builder.mesh.triangles.reserve(size.triangles);
    const double crease = std::cos(options.crease * std::numbers::pi / 180);
    const Circle circle(options.facets), finer(2 * options.facets);
    std::size_t steps = 0;
    for (const Limb& limb : limbs.limbs) {
        if (steps++ % 1024 == 0) budget.check();
        if (!options.cylinders && is_cylinder(limbs, limb)) continue;
        add_tube(builder, limbs.nodes_of(limb), limb, scene, circle, crease);
    }
    for (const Solid& solid : scene.solids) {
        if (steps++ % 1024 == 0) budget.check();
        if (!options.solids) break;
        add_solid(builder, solid, finer, thick);
    }
    builder.mesh.closed = builder.mesh.triangles.size();
    add_sheets(builder, scene, crease, budget);
    if (builder.mesh.triangles.empty() && options.cylinders && options.solids)
        throw Error(scene.name + " draws nothing that has an extent");
    return std::move(builder.mesh);
}

SpaceBox box_of(const Mesh& mesh) {
    SpaceBox box;
    for (const Vector& point : mesh.points) box.add(point);
    return box;
}

double area(const Mesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += length(cross(mesh.place(b) - mesh.place(a), mesh.place(c) - mesh.place(a)));
    return sum / 2;
}

double volume(const Mesh& mesh) {
    const Vector origin = box_of(mesh).low;
    double sum = 0;
    for (std::size_t i = 0; i < mesh.closed; ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        sum += dot(mesh.place(a) - origin, cross(mesh.place(b) - origin, mesh.place(c) - origin));
    }
    return sum / 6;
}

}  // namespace algae
