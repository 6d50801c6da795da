#include "turtle/detail/view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "turtle/detail/mesh.hpp"

// Things as a camera sees them, and which of two hides the other.
//
// Two convex things without a point in common lie on two sides of a plane: the same one is in front
// wherever a line of sight meets both, so one such line decides (de Berg, Cheong, van Kreveld and Overmars
// 2008, 12). The line goes through a common point of both outlines, the middle of their intersection. Two
// sticks are compared where they come closest in the picture; sticks with a common end by their directions
// from there.
//
// Solids become blocks: the facets that look at the camera, the half spaces that bound it, and the convex
// outline. All facets of a solid take their corners from one table of sums, so that equal corners are equal
// numbers: facets that adjoin are found by that. Blocks that hide each other in a ring can be cut in halves.

namespace algae {

namespace {

/// The depths between which a line of sight runs through a thing.
struct Depths {
    double far = 0, near = 0;
};

double across(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double area(std::span<const Point> corners) {
    double sum = 0;
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum += across(corners[0], corners[i - 1], corners[i]);
    return sum / 2;
}

/// The corners of a polygon around what a stick covers.
void outline(const SeenStick& stick, std::vector<Point>& corners) {
    const double dx = stick.to.x - stick.from.x, dy = stick.to.y - stick.from.y,
                 way = std::hypot(dx, dy);
    const double x = way > 0 ? dx / way : 1, y = way > 0 ? dy / way : 0;
    const double a = stick.from_radius, b = stick.to_radius;
    const Seen &f = stick.from, &t = stick.to;
    corners.assign({{f.x - a * x, f.y - a * y},
                    {f.x + a * y, f.y - a * x},
                    {t.x + b * y, t.y - b * x},
                    {t.x + b * x, t.y + b * y},
                    {t.x - b * y, t.y + b * x},
                    {f.x - a * y, f.y + a * x}});
    if (way < std::fabs(a - b) || way == 0) corners = convex_hull(corners);
}

void outline(const SeenBall& ball, std::vector<Point>& corners) {
    constexpr int count = 12;
    corners.clear();
    for (int i = 0; i < count; ++i) {
        const Turn turn = turn_by(360.0 * i / count);
        corners.push_back(
            {ball.middle.x + ball.radius * turn.cosine, ball.middle.y + ball.radius * turn.sine});
    }
}

void outline(const SeenBlock& block, std::vector<Point>& corners) { corners = block.outline; }

Depths depths_at(const SeenStick& stick, Point at) {
    const double dx = stick.to.x - stick.from.x, dy = stick.to.y - stick.from.y,
                 square = dx * dx + dy * dy;
    const double dz = stick.to.depth - stick.from.depth;
    const double ax = at.x - stick.from.x, ay = at.y - stick.from.y;
    const double along = square > 0 ? std::clamp((ax * dx + ay * dy) / square, 0.0, 1.0) : 0.5;
    const double radius = stick.from_radius + along * (stick.to_radius - stick.from_radius);
    const double aside = square > 0 ? (ax * dy - ay * dx) * (ax * dy - ay * dx) / square : 0;
    const double steep = square > 0 ? std::min(4.0, std::sqrt(1 + dz * dz / square)) : 1;
    const double half = steep * std::sqrt(std::max(0.0, radius * radius - aside));
    const double middle = stick.from.depth + along * dz;
    return {middle - half, middle + half};
}

Depths depths_at(const SeenBall& ball, Point at) {
    const double x = at.x - ball.middle.x, y = at.y - ball.middle.y;
    const double half = std::sqrt(std::max(0.0, ball.radius * ball.radius - x * x - y * y));
    return {ball.middle.depth - half, ball.middle.depth + half};
}

Depths depths_at(const SeenBlock& block, Point at) {
    Depths depths{block.low, block.high};
    for (const HalfSpace& bound : block.bounds) {
        const double upright = bound.outward.z;
        if (std::fabs(upright) < 1e-12) continue;
        const double depth =
            (bound.bound - bound.outward.x * at.x - bound.outward.y * at.y) / upright;
        if (block.flat) {
            const double kept = std::clamp(depth, block.low, block.high);
            return {kept, kept};
        }
        if (upright > 0)
            depths.near = std::min(depths.near, depth);
        else
            depths.far = std::max(depths.far, depth);
    }
    return depths;
}

/// Of two sticks that meet there: the sign of how much more the first comes nearer.
int nearer_way(const SeenStick& one, bool one_leaves, const SeenStick& other, bool other_leaves) {
    const auto slope = [](const SeenStick& stick, bool leaves) {
        const double x = stick.to.x - stick.from.x, y = stick.to.y - stick.from.y,
                     z = stick.to.depth - stick.from.depth, all = std::sqrt(x * x + y * y + z * z);
        return all > 0 ? (leaves ? z : -z) / all : 0;
    };
    const double difference = slope(one, one_leaves) - slope(other, other_leaves);
    return difference > 1e-9 ? 1 : difference < -1e-9 ? -1 : 0;
}

bool same(const Seen& a, const Seen& b) { return a.x == b.x && a.y == b.y && a.depth == b.depth; }

int sticks(const SeenStick& one, const SeenStick& other) {
    if (same(one.from, other.to)) return nearer_way(one, true, other, false);
    if (same(one.to, other.from)) return nearer_way(one, false, other, true);
    if (same(one.from, other.from)) return nearer_way(one, true, other, true);
    if (same(one.to, other.to)) return nearer_way(one, false, other, false);
    // Where they come closest in the picture (Ericson 2005, 5.1.9).
    const double ax = one.to.x - one.from.x, ay = one.to.y - one.from.y;
    const double bx = other.to.x - other.from.x, by = other.to.y - other.from.y;
    const double rx = one.from.x - other.from.x, ry = one.from.y - other.from.y;
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, br = bx * rx + by * ry;
    double s = 0.5, t = 0.5;
    if (aa > 0 && bb > 0) {
        const double ab = ax * bx + ay * by, ar = ax * rx + ay * ry, both = aa * bb - ab * ab;
        s = both > 1e-12 * aa * bb ? std::clamp((ab * br - ar * bb) / both, 0.0, 1.0) : 0.5;
        t = (ab * s + br) / bb;
        if (t < 0 || t > 1) {
            t = std::clamp(t, 0.0, 1.0);
            s = std::clamp((t * ab - ar) / aa, 0.0, 1.0);
        }
    } else if (aa > 0) {
        s = std::clamp(-(ax * rx + ay * ry) / aa, 0.0, 1.0);
    } else if (bb > 0) {
        t = std::clamp(br / bb, 0.0, 1.0);
    }
    const double x = one.from.x + s * ax - other.from.x - t * bx,
                 y = one.from.y + s * ay - other.from.y - t * by;
    const double reach = one.from_radius + s * (one.to_radius - one.from_radius) +
                         other.from_radius + t * (other.to_radius - other.from_radius);
    if (x * x + y * y >= reach * reach) return 0;
    const double difference = one.from.depth + s * (one.to.depth - one.from.depth) -
                              other.from.depth - t * (other.to.depth - other.from.depth);
    return difference > 0 ? 1 : difference < 0 ? -1 : 0;
}

/// The corners of a polygon on the inner side of a plane. What `cut` marks is an edge made by it.
SeenFacet kept(const SeenFacet& facet, const HalfSpace& side) {
    SeenFacet part;
    part.colour = facet.colour;
    const std::size_t count = facet.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % count];
        const double at_a = dot(side.outward, a) - side.bound,
                     at_b = dot(side.outward, b) - side.bound;
        if (at_a <= 0) {
            part.corners.push_back(a);
            part.adjoins.push_back(facet.adjoins[i]);
        }
        if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) {
            part.corners.push_back(a + at_a / (at_a - at_b) * (b - a));
            part.adjoins.push_back(at_a < 0 ? Adjoining::cut : facet.adjoins[i]);
        }
    }
    return part;
}

SeenBlock half(const SeenBlock& block, const HalfSpace& side) {
    SeenBlock part;
    part.flat = block.flat;
    part.has_edges = block.has_edges;
    part.bounds = block.bounds;
    if (!block.flat) part.bounds.push_back(side);
    part.low = block.high;
    part.high = block.low;
    for (const SeenFacet& facet : block.facets) {
        SeenFacet piece = kept(facet, side);
        if (piece.corners.size() < 3) continue;
        for (const Vector& corner : piece.corners) {
            part.low = std::min(part.low, corner.z);
            part.high = std::max(part.high, corner.z);
        }
        part.facets.push_back(std::move(piece));
    }
    // What is hidden may reach farther back than what is seen.
    if (!block.flat) part.low = block.low;
    const std::size_t count = block.outline.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Point a = block.outline[i], b = block.outline[(i + 1) % count];
        const double at_a = side.outward.x * a.x + side.outward.y * a.y - side.bound;
        const double at_b = side.outward.x * b.x + side.outward.y * b.y - side.bound;
        if (at_a <= 0) part.outline.push_back(a);
        const double share = at_a / (at_a - at_b);
        if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))
            part.outline.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
    }
    return part;
}

}  // namespace

std::vector<Point> convex_hull(std::vector<Point> points) {
    // Andrew's chains (1979).
    std::sort(points.begin(), points.end(),
              [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<Point> hull;
    const auto chain = [&hull](auto from, auto to) {
        const std::size_t fixed = hull.size();
        for (auto point = from; point != to; ++point) {
            while (hull.size() >= fixed + 2 &&
                   across(hull[hull.size() - 2], hull.back(), *point) <= 0)
                hull.pop_back();
            hull.push_back(*point);
        }
        hull.pop_back();
    };
    chain(points.begin(), points.end());
    chain(points.rbegin(), points.rend());
    return hull;
}

std::optional<Point> common_point(std::span<const Point> one, std::span<const Point> other) {
    if (one.size() < 3 || other.size() < 3) return std::nullopt;
    thread_local std::vector<Point> common, next;
    common.assign(one.begin(), one.end());
    for (std::size_t i = 0; i < other.size() && common.size() >= 3; ++i) {
        const Point a = other[i], b = other[(i + 1) % other.size()];
        next.clear();
        for (std::size_t j = 0; j < common.size(); ++j) {
            const Point c = common[j], d = common[(j + 1) % common.size()];
            const double at_c = across(a, b, c), at_d = across(a, b, d);
            if (at_c >= 0) next.push_back(c);
            const double share = at_c / (at_c - at_d);
            if ((at_c > 0 && at_d < 0) || (at_c < 0 && at_d > 0))
                next.push_back({c.x + share * (d.x - c.x), c.y + share * (d.y - c.y)});
        }
        common.swap(next);
    }
    if (common.size() < 3) return std::nullopt;
    const double shared = area(common);
    if (!(shared > 1e-7 * std::min(area(one), area(other)))) return std::nullopt;
    double x = 0, y = 0;
    for (std::size_t i = 2; i < common.size(); ++i) {
        const double part = across(common[0], common[i - 1], common[i]) / 2;
        x += part * (common[0].x + common[i - 1].x + common[i].x) / 3;
        y += part * (common[0].y + common[i - 1].y + common[i].y) / 3;
    }
    return Point{x / shared, y / shared};
}

Extent extent_of(const SeenThing& thing) {
    Extent extent;
    if (const auto* stick = std::get_if<SeenStick>(&thing)) {
        const Seen &a = stick->from, &b = stick->to;
        const double r = stick->from_radius, s = stick->to_radius;
        extent = {std::min(a.x - r, b.x - s), std::max(a.x + r, b.x + s),
                  std::min(a.y - r, b.y - s), std::max(a.y + r, b.y + s), (a.depth + b.depth) / 2};
    } else if (const auto* ball = std::get_if<SeenBall>(&thing)) {
        const Seen& m = ball->middle;
        extent = {m.x - ball->radius, m.x + ball->radius, m.y - ball->radius, m.y + ball->radius,
                  m.depth};
    } else {
        const auto& block = std::get<SeenBlock>(thing);
        bool first = true;
        for (const Point& corner : block.outline) {
            extent.left = first ? corner.x : std::min(extent.left, corner.x);
            extent.right = first ? corner.x : std::max(extent.right, corner.x);
            extent.bottom = first ? corner.y : std::min(extent.bottom, corner.y);
            extent.top = first ? corner.y : std::max(extent.top, corner.y);
            first = false;
        }
        extent.depth = (block.low + block.high) / 2;
    }
    return extent;
}

int hides(const SeenThing& one, const SeenThing& other) {
    const auto *a = std::get_if<SeenStick>(&one), *b = std::get_if<SeenStick>(&other);
    if (a && b) return sticks(*a, *b);
    thread_local std::vector<Point> left, right;
    std::visit([](const auto& thing) { outline(thing, left); }, one);
    std::visit([](const auto& thing) { outline(thing, right); }, other);
    const std::optional<Point> at = common_point(left, right);
    if (!at) return 0;
    const auto depths = [&](const SeenThing& thing) {
        return std::visit([&](const auto& kind) { return depths_at(kind, *at); }, thing);
    };
    const Depths first = depths(one), second = depths(other);
    const double difference = first.near + first.far - second.near - second.far;
    return difference > 0 ? 1 : difference < 0 ? -1 : 0;
}

std::pair<SeenBlock, SeenBlock> halves(const SeenBlock& block) {
    const Extent extent = extent_of(block);
    const bool across_x = extent.right - extent.left >= extent.top - extent.bottom;
    HalfSpace side;
    side.outward = across_x ? Vector{1, 0, 0} : Vector{0, 1, 0};
    side.bound = across_x ? (extent.left + extent.right) / 2 : (extent.bottom + extent.top) / 2;
    return {half(block, side), half(block, {-1.0 * side.outward, -side.bound})};
}

void complete(SeenBlock& block, std::span<const Vector> corners) {
    std::vector<Point> points;
    for (const Vector& corner : corners) {
        points.push_back({corner.x, corner.y});
        block.low = points.size() == 1 ? corner.z : std::min(block.low, corner.z);
        block.high = points.size() == 1 ? corner.z : std::max(block.high, corner.z);
    }
    block.outline = convex_hull(std::move(points));
    for (SeenFacet& facet : block.facets)
        facet.adjoins.resize(facet.corners.size(), Adjoining::nothing);
    for (std::size_t first = 0; first < block.facets.size(); ++first)
        for (std::size_t second = first + 1; second < block.facets.size(); ++second) {
            SeenFacet &facet = block.facets[first], &other = block.facets[second];
            const std::size_t corners_here = facet.corners.size(),
                              corners_there = other.corners.size();
            for (std::size_t i = 0; i < corners_here; ++i)
                for (std::size_t j = 0; j < corners_there; ++j)
                    if (facet.corners[i] == other.corners[(j + 1) % corners_there] &&
                        facet.corners[(i + 1) % corners_here] == other.corners[j]) {
                        facet.adjoins[i] = Adjoining::later;
                        other.adjoins[j] = Adjoining::earlier;
                    }
        }
}

namespace {

Vector placed(const Solid& solid, double heading, double left, double up) {
    return solid.middle + heading * solid.attitude.heading() + left * solid.attitude.left() +
           up * solid.attitude.up();
}

/// The points around a circle across the heading, counter-clockwise seen from ahead.
std::vector<Vector> circle(const Solid& solid, double along, int sides) {
    std::vector<Vector> points;
    for (int i = 0; i < sides; ++i) {
        const Turn turn = turn_by(360.0 * i / sides);
        points.push_back(
            placed(solid, along, solid.size.y * turn.cosine, solid.size.y * turn.sine));
    }
    return points;
}

/// Collects the sides of a convex solid.
class BlockBuilder {
public:
    BlockBuilder(const Colour& colour, const Projection& projection, const Lighting& lighting)
        : colour_(colour), projection_(projection), lighting_(lighting) {}

    /// A side with these corners, counter-clockwise seen from outside.
    void side(std::span<const Vector> corners, const Vector& normal) {
        SeenFacet facet;
        double depth = 0;
        for (const Vector& corner : corners) {
            const Seen seen = projection_(corner);
            facet.corners.push_back({seen.x, seen.y, seen.depth});
            depth += seen.depth / static_cast<double>(corners.size());
        }
        const Vector outward = twice_area(facet.corners);
        const double size = length(outward);
        all_.insert(all_.end(), facet.corners.begin(), facet.corners.end());
        if (!(size > 0)) return;
        const Vector direction = (1 / size) * outward;
        block_.bounds.push_back({direction, dot(direction, facet.corners.front())});
        if (!(outward.z > 0)) return;
        facet.colour = lighting_(colour_, normal, depth);
        block_.facets.push_back(std::move(facet));
    }

    void mark_edges() { block_.has_edges = true; }

    SeenBlock finished() {
        complete(block_, all_);
        return std::move(block_);
    }

private:
    Colour colour_;
    const Projection& projection_;
    const Lighting& lighting_;
    SeenBlock block_;
    std::vector<Vector> all_;
};

void add_box(BlockBuilder& builder, const Solid& solid) {
    builder.mark_edges();
    const Vector half = 0.5 * solid.size;
    const std::array<Vector, 3> axes{solid.attitude.heading(), solid.attitude.left(),
                                     solid.attitude.up()};
    const std::array<double, 3> reach{half.x, half.y, half.z};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
            std::array<Vector, 4> corners;
            constexpr std::array<std::array<int, 2>, 4> around{
                {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
            for (std::size_t i = 0; i < 4; ++i)
            // The other way round on the far side. All sides sum in one order, so that corners agree.
            {
                std::array<double, 3> at{};
                at[axis] = sign * reach[axis];
                at[next] = around[i][0] * reach[next] * sign;
                at[last] = around[i][1] * reach[last];
                corners[i] = placed(solid, at[0], at[1], at[2]);
            }
            builder.side(corners, sign * axes[axis]);
        }
}

void add_round(BlockBuilder& builder, const Solid& solid, int sides) {
    const bool pointed = solid.shape == SolidShape::cone;
    const double half = solid.size.x / 2;
    std::vector<Vector> base = circle(solid, -half, sides), top;
    if (!pointed) top = circle(solid, half, sides);
    const Vector tip = placed(solid, half, 0, 0);
    for (int i = 0; i < sides; ++i) {
        const auto here = static_cast<std::size_t>(i),
                   after = static_cast<std::size_t>((i + 1) % sides);
        const Turn turn = turn_by(360.0 * (i + 0.5) / sides);
        Vector normal = turn.cosine * solid.attitude.left() + turn.sine * solid.attitude.up();
        if (pointed) {
            normal = unit(solid.size.x * normal + solid.size.y * solid.attitude.heading());
            builder.side(std::array{base[here], base[after], tip}, normal);
        } else {
            builder.side(std::array{base[here], base[after], top[after], top[here]}, normal);
        }
    }
    if (!pointed) builder.side(top, solid.attitude.heading());
    builder.side(std::vector<Vector>(base.rbegin(), base.rend()), -1.0 * solid.attitude.heading());
}

}  // namespace

int sides_of(double radius, double resolution) {
    const double seen = resolution > 0 ? radius / resolution : 100;
    return seen < 4 ? 8 : seen < 12 ? 16 : seen < 100 ? 32 : 64;
}

SeenThing seen(const Solid& solid, const Colour& colour, int sides, const Projection& projection,
               const Lighting& lighting) {
    if (solid.shape == SolidShape::sphere) {
        const Seen middle = projection(solid.middle);
        return SeenBall{middle, solid.size.x * middle.scale, colour};
    }
    BlockBuilder builder(colour, projection, lighting);
    if (solid.shape == SolidShape::box)
        add_box(builder, solid);
    else
        add_round(builder, solid, sides);
    return builder.finished();
}

SeenThing seen(std::span<const Vector> corners, std::span<const char> adjoins, const Colour& colour,
               const Projection& projection, const Lighting& lighting) {
    SeenBlock block;
    block.flat = true;
    SeenFacet facet;
    Vector middle;
    for (const Vector& corner : corners) {
        const Seen seen = projection(corner);
        facet.corners.push_back({seen.x, seen.y, seen.depth});
        middle = middle + (1 / static_cast<double>(corners.size())) * corner;
    }
    for (const char edge : adjoins)
        facet.adjoins.push_back(edge ? Adjoining::later : Adjoining::nothing);
    Vector normal = unit(twice_area(corners));
    if (dot(normal, projection.to_camera(middle)) < 0) normal = -1.0 * normal;
    const Seen at = projection(middle);
    facet.colour = lighting(colour, normal, at.depth);
    const Vector outward = unit(twice_area(facet.corners));
    block.bounds.push_back({outward, dot(outward, {at.x, at.y, at.depth})});
    const std::vector<Vector> seen_corners = facet.corners;
    block.facets.push_back(std::move(facet));
    complete(block, seen_corners);
    return block;
}

std::vector<Vector> corners_of(const Solid& solid) {
    std::vector<Vector> corners;
    const double half = solid.size.x / 2;
    switch (solid.shape) {
        case SolidShape::box:
            for (const double x : {-1.0, 1.0})
                for (const double y : {-1.0, 1.0})
                    for (const double z : {-1.0, 1.0})
                        corners.push_back(
                            placed(solid, x * half, y * solid.size.y / 2, z * solid.size.z / 2));
            break;
        case SolidShape::cylinder: {
            corners = circle(solid, half, 64);
            [[fallthrough]];
        }
        case SolidShape::cone: {
            for (const Vector& point : circle(solid, -half, 64)) corners.push_back(point);
            if (solid.shape == SolidShape::cone) corners.push_back(placed(solid, half, 0, 0));
            break;
        }
        case SolidShape::sphere:
            corners.push_back(solid.middle);
            break;
    }
    return corners;
}

}  // namespace algae
