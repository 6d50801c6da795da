#pragma once
// space: solid figures, and how a camera sees them. Knows no picture and no mesh format.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "system/settings.hpp"
#include "turtle/pose.hpp"
#include "turtle/solid_shape.hpp"

namespace algae {

/// What something is painted with: a colour of its own, or one of the list of its scene.
struct Paint {
    std::uint32_t index = 0;       // in the scene's list, which comes round again
    std::optional<Colour> colour;  // instead of it
    bool operator==(const Paint&) const = default;
};

/// The box with sides along the axes around something in space; `empty` when there is nothing.
struct SpaceBox {
    Vector low, high;
    bool empty = true;

    void add(const Vector& point);
    void add(const SpaceBox& box);
    /// From `low` to `high`; 0 for nothing.
    double diagonal() const;
    bool operator==(const SpaceBox&) const = default;
};

/// One straight stroke of a turtle: a round rod, or a line where it has no thickness.
struct Rod {
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    Vector from, to;
    double radius = 0;      // in the units of the file; 0: a line
    double line_width = 1;  // of a line, as a multiple of the scene's
    Paint paint;
    std::uint32_t before = none;  // the rod at whose end this one begins, if it begins at one
    bool branch = false;          // it begins a branch there, and another rod goes on
};

/// A flat polygon; its corners are a run of the scene's.
struct Face {
    std::uint32_t first = 0, corners = 0;
    Paint paint;
};

/// A solid by its middle, the way it is turned, and its measures. A box has `size` along heading,
/// left and up of `attitude`. A cylinder and a cone have the height `size.x` along the heading and the
/// radius `size.y` (of a cone that of its base, which is behind); a sphere the radius `size.x`.
struct Solid {
    SolidShape shape = SolidShape::box;
    Vector middle;
    Attitude attitude;
    Vector size;
    Paint paint;
};

/// All that is to be seen of a figure in space, in the units of the file: x and y are the plane's,
/// z is up.
struct Scene {
    std::vector<Rod> rods;
    std::vector<Vector> corners;
    std::vector<Face> faces;
    std::vector<Solid> solids;
    std::vector<std::string> colours;  // as in Settings
    std::string name;                  // "generation 8 of honda", as messages call it

    /// Appends a face with these corners.
    void add_face(std::span<const Vector> points, const Paint& paint);
    std::span<const Vector> corners_of(const Face& face) const {
        return std::span(corners).subspan(face.first, face.corners);
    }
    bool empty() const { return rods.empty() && faces.empty() && solids.empty(); }
    /// How many rods, faces and solids there are.
    std::size_t parts() const { return rods.size() + faces.size() + solids.size(); }
};

/// The smallest box around a solid.
SpaceBox box_of(const Solid& solid);

/// The box around the axes of the rods and around faces and solids: without the thickness of rods.
SpaceBox box_of(const Scene& scene);

/// The sum of the lengths of all rods.
///
/// Example: total_length(Scene{}) == 0
double total_length(const Scene& scene);

}  // namespace algae
