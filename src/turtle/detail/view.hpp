#pragma once
// What the sources of a picture of a scene share: the light, things as a camera sees them, the order
// in which they are painted, and their painter.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "turtle/turtle.hpp"

namespace algae {

/// The unit vector from the figure towards something that stands there.
///
/// Example: direction_of(-90, 0) == Vector{0, -1, 0}
Vector direction_of(double azimuth, double elevation);

/// The light over the left shoulder of somebody who looks through this camera.
///
/// Example: usual_light(Camera{-90, 0}) == Light{-130, 40}
Light usual_light(const Camera& camera);

/// Throws Error unless both angles are finite and the elevation is -90 to 90.
void check_light(const Light& light);

/// The colours of lit surfaces: light from one direction, some from everywhere, and haze that takes
/// away from what is far (Foley, van Dam, Feiner and Hughes 1990, 16.1).
class Lighting {
public:
    /// `fog` is the share of the background in the colour of what lies at the depth `farthest`; none
    /// at `nearest`.
    Lighting(const Light& light, double fog, const Colour& background, double farthest,
             double nearest);

    /// A surface of this colour with this unit normal, at this depth.
    Colour operator()(const Colour& colour, const Vector& normal, double depth) const {
        return at_depth(lit(colour, dot(normal, toward_)), depth);
    }
    /// What `dot(normal, light)` makes of a colour, without fog.
    static Colour lit(const Colour& colour, double cosine);
    /// A colour seen through the fog.
    Colour at_depth(const Colour& colour, double depth) const;
    const Vector& toward() const { return toward_; }

private:
    Vector toward_;
    double fog_, farthest_, nearest_;
    Colour background_;
};

/// What a painter knows of a thing before looking closely: the box around it in the picture, and how
/// near it is on the whole.
struct Extent {
    double left = 0, right = 0, bottom = 0, top = 0;
    double depth = 0;     // larger is nearer
    bool slight = false;  // too small for anybody to see which of two such things is in front
};

/// The order in which things are painted, each over those before.
struct PaintingOrder {
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t>
        knotted;  // those that hide each other in a ring, so that no order is right
};

/// Whether the first of two things hides some of the second (above 0), the second some of the first
/// (below 0), or neither.
using Hiding = std::function<int(std::uint32_t, std::uint32_t)>;

/// An order in which everything comes after what it hides, and as far as that leaves free, by depth.
///
/// Things whose boxes meet are compared, except slight ones with each other; the relation is sorted
/// topologically, the farthest first. O(n log n) and one comparison for each pair of boxes that meet,
/// at most `most_comparisons`; beyond that depth decides.
PaintingOrder painting_order(std::span<const Extent> things, const Hiding& hiding,
                             const Budget& budget);

/// A straight round piece of a rod as a camera sees it.
struct SeenStick {
    std::uint32_t rod = 0;
    double begins = 0, ends = 1;  // the piece, as shares of the rod
    Seen from, to;
    double from_radius = 0, to_radius = 0;  // in the picture
};

/// A sphere.
struct SeenBall {
    Seen middle;
    double radius = 0;  // in the picture
    Colour colour;      // without light
};

/// What goes on at an edge of a facet.
enum class Adjoining : char {
    nothing,
    later,    // a facet that is painted later, or may be
    earlier,  // one that is painted already
    cut       // the other half of the same facet
};

/// A flat, lit part of a surface, in the camera's coordinates.
struct SeenFacet {
    std::vector<Vector> corners;
    std::vector<Adjoining> adjoins;  // by edge, from the corner of that number on
    Colour colour;
};

/// Where outward.x * x + outward.y * y + outward.z * z <= bound.
struct HalfSpace {
    Vector outward;
    double bound = 0;
};

/// A convex solid with flat sides, or a flat polygon, as a camera sees it: the facets on this side,
/// what bounds it, and its outline.
struct SeenBlock {
    std::vector<SeenFacet> facets;
    std::vector<HalfSpace> bounds;  // of a polygon: its plane alone
    std::vector<Point> outline;     // convex, counter-clockwise
    double low = 0, high = 0;       // its depths
    bool flat = false;
    bool has_edges = false;  // they are marked, so that equal ones beside it can be told apart
};

using SeenThing = std::variant<SeenStick, SeenBall, SeenBlock>;

/// The box around a thing, and the depth of its middle.
Extent extent_of(const SeenThing& thing);

/// Whether the first thing hides some of the second (1), is hidden (-1), or neither (0).
///
/// Two convex things without a point in common lie on two sides of a plane: the same one is in front
/// wherever a line of sight meets both, so one such line decides (de Berg, Cheong, van Kreveld and
/// Overmars 2008, 12). Where things touch or pierce each other, the one whose middle is nearer on
/// that line counts as in front; of sticks with a common end the one that comes nearer from there.
int hides(const SeenThing& one, const SeenThing& other);

/// The smallest convex polygon around points, counter-clockwise.
///
/// Example: convex_hull({{0, 0}, {1, 0}, {0.5, 0.2}, {0, 1}}).size() == 3
std::vector<Point> convex_hull(std::vector<Point> points);

/// A point of the plane inside both convex polygons, counter-clockwise, or nothing if they have no
/// more than an edge in common.
std::optional<Point> common_point(std::span<const Point> one, std::span<const Point> other);

/// A block cut in two across the longer side of its outline. The halves' facets adjoin.
std::pair<SeenBlock, SeenBlock> halves(const SeenBlock& block);

/// Sets what a block's facets say of it: its outline and depths from all its corners, and which edges
/// adjoin.
void complete(SeenBlock& block, std::span<const Vector> corners);

/// How many flat sides a round solid of this radius has in a picture where details of this size are
/// seen: 8, 16, 32 or 64.
int sides_of(double radius, double resolution);

/// A solid as a camera sees it, in the light. `sides` stand for the roundness of a cylinder or a cone.
SeenThing seen(const Solid& solid, const Colour& colour, int sides, const Projection& projection,
               const Lighting& lighting);

/// A polygon, lit on both sides. `adjoins`: its edges at which another polygon goes on.
SeenThing seen(std::span<const Vector> corners, std::span<const char> adjoins, const Colour& colour,
               const Projection& projection, const Lighting& lighting);

/// Every corner of a box, or points around the circles of a cylinder and a cone, 64 to a circle.
std::vector<Vector> corners_of(const Solid& solid);

}  // namespace algae
