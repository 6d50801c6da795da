#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "space/camera.hpp"
#include "space/painting_order.hpp"
#include "system/settings.hpp"
#include "turtle/canvas.hpp"

namespace algae {

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

}  // namespace algae
