#include "turtle/detail/mesh.hpp"
#include "watch/watch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

// A scene as triangles: tubes, solids and sheets.
//
// A limb becomes one closed tube. A ring of points stands at each node, in the plane of the mitre where the
// tube turns, and is joined to the next ring by a side of triangles. The cross section is carried along
// without twist by reflections in the planes of the mitres (Wang et al., Computation of rotation minimizing
// frames, 2008). Ends are flat, or round where something would show otherwise. Solids are closed surfaces of
// their own. Polygons become sheets, triangulated one by one, whose corners share a normal where polygons
// of one paint meet at less than the crease.
//
// In the closed part every directed edge between points is in one triangle and its reverse in one; a point is
// shared by corners that differ in normal or paint. The size of the mesh is known before it is built, up to
// corners that shading merges, so that a mesh that is too large stops before it takes memory.

namespace algae {

namespace {

auto key(const Paint& paint) {
    const Colour colour = paint.colour.value_or(Colour{});
    return std::tuple(paint.colour.has_value(), paint.index, colour.red, colour.green, colour.blue);
}

/// The corners of a regular polygon around the origin of a plane, first on the first axis.
class Circle {
public:
    explicit Circle(unsigned sides) {
        for (unsigned k = 0; k < sides; ++k) {
            const double angle = 2 * std::numbers::pi * k / sides;
            parts_.emplace_back(std::cos(angle), std::sin(angle));
        }
    }
    unsigned sides() const { return static_cast<unsigned>(parts_.size()); }
    /// The unit vector at corner k in the plane of two orthogonal unit vectors.
    Vector at(unsigned k, const Vector& first, const Vector& second) const {
        return parts_[k].first * first + parts_[k].second * second;
    }

private:
    std::vector<std::pair<double, double>> parts_;
};

/// A mesh that grows.
class MeshBuilder {
public:
    /// `colours` is how many the scene's list has, which comes round again.
    explicit MeshBuilder(std::size_t colours) : colours_(colours ? colours : 1) {}

    /// What corners are painted with from here on.
    void paint(const Paint& paint) {
        Paint wanted = paint;
        wanted.index = paint.colour ? 0 : static_cast<std::uint32_t>(paint.index % colours_);
        if (!mesh.paints.empty() && mesh.paints[paint_] == wanted) return;
        const auto place = std::lower_bound(
            sorted_.begin(), sorted_.end(), wanted,
            [&](std::uint32_t known, const Paint& p) { return key(mesh.paints[known]) < key(p); });
        if (place != sorted_.end() && mesh.paints[*place] == wanted) {
            paint_ = *place;
            return;
        }
        paint_ = static_cast<std::uint32_t>(mesh.paints.size());
        mesh.paints.push_back(wanted);
        sorted_.insert(place, paint_);
    }
    std::uint32_t point(const Vector& place) {
        mesh.points.push_back(place);
        return static_cast<std::uint32_t>(mesh.points.size() - 1);
    }
    std::uint32_t corner(std::uint32_t point, const Vector& normal) {
        mesh.corners.push_back({point, paint_, normal});
        return static_cast<std::uint32_t>(mesh.corners.size() - 1);
    }
    /// Corners counter-clockwise seen from outside.
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh.triangles.push_back({a, b, c});
    }
    std::uint32_t point_of(std::uint32_t corner) const { return mesh.corners[corner].point; }
    std::uint32_t current_paint() const { return paint_; }

    Mesh mesh;

private:
    std::size_t colours_;
    std::uint32_t paint_ = 0;
    std::vector<std::uint32_t> sorted_;  // paints by value
};

/// A run of points or corners around something, counter-clockwise seen from its tip.
using Ring = std::vector<std::uint32_t>;

/// A side between two rings of corners, the second toward the tip.
void add_side(MeshBuilder& builder, const Ring& foot, const Ring& tip) {
    for (std::size_t k = 0; k < foot.size(); ++k) {
        const std::size_t next = k + 1 == foot.size() ? 0 : k + 1;
        builder.triangle(foot[k], foot[next], tip[next]);
        builder.triangle(foot[k], tip[next], tip[k]);
    }
}

/// Closes a ring of corners by a flat polygon with this outward normal; `at_tip` says which side.
void add_flat_end(MeshBuilder& builder, const Ring& ring, const Vector& normal, bool at_tip) {
    Ring corners;
    for (const std::uint32_t corner : ring)
        corners.push_back(builder.corner(builder.point_of(corner), normal));
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        builder.triangle(corners[0], corners[at_tip ? k : k + 1], corners[at_tip ? k + 1 : k]);
}

/// Closes a ring of corners by a triangle from each of its sides to a point: `corner(k)` is the corner there of
/// side k.
template <class Corner>
void add_point_end(MeshBuilder& builder, const Ring& ring, bool at_tip, Corner corner) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::uint32_t a = ring[k], b = ring[k + 1 == ring.size() ? 0 : k + 1];
        builder.triangle(at_tip ? a : b, at_tip ? b : a, corner(k));
    }
}

/// How many triangles and, at most, corners and points a part has.
struct TubeSize {
    std::uint64_t triangles = 0, corners = 0, points = 0;
};

/// How many rings, its own among them, a round end has below its point.
unsigned rings_of_end(unsigned sides) { return sides < 6 ? 1 : (sides + 2) / 4; }

/// The way along a piece of a tube and two axes across it, right-handed in the order first, second,
/// along.
struct Frame {
    Vector along, first, second;

    explicit Frame(const Vector& direction) : along(unit(direction)) {
        // Across and level; where the way is steep, across and toward x.
        const Vector level = cross({0, 0, 1}, along);
        first = length(level) > 1e-3 ? unit(level) : unit(cross({0, 1, 0}, along));
        second = cross(along, first);
    }
    /// The frame after a turn: reflected in the plane of the mitre, so that nothing twists.
    Frame turned(const Vector& direction) const {
        Frame next = *this;
        next.along = unit(direction);
        const Vector mitre = unit(along + next.along);
        next.first = first - (2 * dot(first, mitre)) * mitre;
        next.first = unit(next.first - dot(next.first, next.along) * next.along);
        next.second = cross(next.along, next.first);
        return next;
    }
};

/// A piece of a tube between two nodes.
struct Piece {
    Frame frame;
    double length = 0, narrowing = 0;

    Piece(const Limbs::Node& from, const Limbs::Node& to, const Frame& f)
        : frame(f),
          length(algae::length(to.point - from.point)),
          narrowing(from.radius - to.radius) {}
    Vector normal(const Circle& circle, unsigned k) const {
        return unit(length * circle.at(k, frame.first, frame.second) + narrowing * frame.along);
    }
};

class Tube {
public:
    Tube(MeshBuilder& builder, const Circle& circle) : builder_(builder), circle_(circle) {}

    Ring flat_ring(const Limbs::Node& node, const Frame& frame) {
        return ring([&](unsigned k) {
            return node.point + node.radius * circle_.at(k, frame.first, frame.second);
        });
    }
    /// The ring in the plane that halves the turn from one frame to the next.
    Ring mitred_ring(const Limbs::Node& node, const Frame& frame, const Frame& next) {
        const Vector mitre = unit(frame.along + next.along);
        const double lean = dot(frame.along, mitre);
        return ring([&](unsigned k) {
            const Vector across = node.radius * circle_.at(k, frame.first, frame.second);
            return node.point + across - (dot(across, mitre) / lean) * frame.along;
        });
    }
    template <class Normal>
    Ring corners(const Ring& points, const Normal& normal) {
        Ring found(points.size());
        for (unsigned k = 0; k < found.size(); ++k)
            found[k] = builder_.corner(points[k], normal(k));
        return found;
    }
    /// Closes a ring of corners by half a ball that looks toward `out`.
    void add_round_end(Ring corner_ring, const Limbs::Node& node, const Frame& frame, bool at_tip) {
        const Vector out = at_tip ? frame.along : -1.0 * frame.along;
        const unsigned rings = rings_of_end(circle_.sides());
        for (unsigned i = 1; i < rings; ++i) {
            const double angle = std::numbers::pi / 2 * i / rings;
            const auto normal = [&](unsigned k) {
                return std::cos(angle) * circle_.at(k, frame.first, frame.second) +
                       std::sin(angle) * out;
            };
            const Ring higher = corners(
                ring([&](unsigned k) { return node.point + node.radius * normal(k); }), normal);
            if (at_tip)
                add_side(builder_, corner_ring, higher);
            else
                add_side(builder_, higher, corner_ring);
            corner_ring = higher;
        }
        const std::uint32_t pole =
            builder_.corner(builder_.point(node.point + node.radius * out), out);
        add_point_end(builder_, corner_ring, at_tip, [&](std::size_t) { return pole; });
    }

private:
    template <class Place>
    Ring ring(const Place& place) {
        Ring points(circle_.sides());
        for (unsigned k = 0; k < points.size(); ++k) points[k] = builder_.point(place(k));
        return points;
    }

    MeshBuilder& builder_;
    const Circle& circle_;
};

/// Adds a limb as a closed tube: a ring of points at each node, in the plane of the mitre where it
/// turns. `crease` is the cosine of the largest turn that is shaded smoothly.
void add_tube(MeshBuilder& builder, std::span<const Limbs::Node> nodes, const Limb& limb,
              const Scene& scene, const Circle& circle, double crease) {
    Tube tube(builder, circle);
    const auto paint = [&](std::size_t i) { return scene.rods[nodes[i].rod].paint; };
    builder.paint(paint(0));
    Piece piece(nodes[0], nodes[1], Frame(nodes[1].point - nodes[0].point));
    Ring points = tube.flat_ring(nodes[0], piece.frame);
    const auto straight = [&](unsigned k) { return piece.normal(circle, k); };
    Ring foot = tube.corners(points, straight);
    if (limb.round_foot)
        tube.add_round_end(foot, nodes[0], piece.frame, false);
    else
        add_flat_end(builder, foot, -1.0 * piece.frame.along, false);
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
        const Vector onward = nodes[i + 1].point - nodes[i].point;
        const Piece next(nodes[i], nodes[i + 1], piece.frame.turned(onward));
        points = tube.mitred_ring(nodes[i], piece.frame, next.frame);
        const bool smooth = dot(piece.frame.along, next.frame.along) >= crease;
        const auto halfway = [&](unsigned k) {
            return unit(piece.normal(circle, k) + next.normal(circle, k));
        };
        const Ring tip = smooth ? tube.corners(points, halfway) : tube.corners(points, straight);
        add_side(builder, foot, tip);
        piece = next;
        if (smooth && paint(i) == paint(i - 1)) {
            foot = tip;
            continue;
        }
        builder.paint(paint(i));
        foot.clear();
        for (unsigned k = 0; k < points.size(); ++k)
            foot.push_back(builder.corner(
                points[k], smooth ? builder.mesh.corners[tip[k]].normal : straight(k)));
    }
    points = tube.flat_ring(nodes.back(), piece.frame);
    const Ring tip = tube.corners(points, straight);
    add_side(builder, foot, tip);
    if (limb.round_end)
        tube.add_round_end(tip, nodes.back(), piece.frame, true);
    else
        add_flat_end(builder, tip, piece.frame.along, true);
}

TubeSize tube_size(const Limb& limb, unsigned sides) {
    const std::uint64_t k = sides, rings = rings_of_end(sides), pieces = limb.nodes - 1;
    TubeSize size{2 * k * pieces, 2 * k * pieces, k * limb.nodes};
    for (const bool round : {limb.round_foot, limb.round_end}) {
        size.triangles += round ? 2 * k * (rings - 1) + k : k - 2;
        size.corners += round ? k * (rings - 1) + 1 : k;
        if (round) size.points += k * (rings - 1) + 1;
    }
    return size;
}

/// A ring of corners around `middle` across the heading.
template <class Normal>
Ring ring(MeshBuilder& builder, const Circle& circle, const Vector& middle, double radius,
          const Attitude& attitude, const Normal& normal) {
    Ring corners(circle.sides());
    for (unsigned k = 0; k < corners.size(); ++k) {
        const Vector across = circle.at(k, attitude.left(), attitude.up());
        corners[k] = builder.corner(builder.point(middle + radius * across), normal(across));
    }
    return corners;
}

void add_box(MeshBuilder& builder, const Solid& solid, const Vector& size) {
    const Attitude& a = solid.attitude;
    const std::array<Vector, 3> axes{a.heading(), a.left(), a.up()};
    const std::array<double, 3> half{size.x / 2, size.y / 2, size.z / 2};
    std::array<std::uint32_t, 8> points;
    for (unsigned i = 0; i < 8; ++i) {
        Vector place = solid.middle;
        for (unsigned axis = 0; axis < 3; ++axis)
            place = place + (i >> axis & 1 ? half[axis] : -half[axis]) * axes[axis];
        points[i] = builder.point(place);
    }
    for (unsigned axis = 0; axis < 3; ++axis)
        for (const unsigned side : {0u, 1u}) {
            // Seen from outside, the next axis and the one after it go round counter-clockwise.
            const unsigned u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3, base = side << axis;
            std::array<unsigned, 4> around{base, base | u, base | u | v, base | v};
            if (!side) std::swap(around[1], around[3]);
            const Vector normal = (side ? 1.0 : -1.0) * axes[axis];
            std::array<std::uint32_t, 4> c;
            for (unsigned i = 0; i < 4; ++i) c[i] = builder.corner(points[around[i]], normal);
            builder.triangle(c[0], c[1], c[2]);
            builder.triangle(c[0], c[2], c[3]);
        }
}

void add_cylinder(MeshBuilder& builder, const Solid& solid, const Circle& circle, double height,
                  double radius) {
    const Vector& along = solid.attitude.heading();
    const auto outward = [](const Vector& across) { return across; };
    const Vector half = (height / 2) * along;
    const Ring foot = ring(builder, circle, solid.middle - half, radius, solid.attitude, outward);
    const Ring tip = ring(builder, circle, solid.middle + half, radius, solid.attitude, outward);
    add_side(builder, foot, tip);
    add_flat_end(builder, foot, -1.0 * along, false);
    add_flat_end(builder, tip, along, true);
}

void add_cone(MeshBuilder& builder, const Solid& solid, const Circle& circle, double height,
              double radius) {
    const Vector& along = solid.attitude.heading();
    const auto outward = [&](const Vector& across) {
        return unit(height * across + radius * along);
    };
    const Vector half = (height / 2) * along;
    const Ring foot = ring(builder, circle, solid.middle - half, radius, solid.attitude, outward);
    const std::uint32_t tip = builder.point(solid.middle + half);
    add_point_end(
        builder, foot, true, [&](std::size_t k) {  // with the normal of the middle of the side
            const Vector normal = builder.mesh.corners[foot[k]].normal;
            return builder.corner(
                tip, unit(normal + builder.mesh.corners[foot[(k + 1) % foot.size()]].normal));
        });
    add_flat_end(builder, foot, -1.0 * along, false);
}

void add_sphere(MeshBuilder& builder, const Solid& solid, const Circle& circle, double radius) {
    const Vector& along = solid.attitude.heading();
    const unsigned latitudes = circle.sides() / 2;
    const auto pole = [&](double side) {
        return builder.corner(builder.point(solid.middle + (side * radius) * along), side * along);
    };
    const std::uint32_t south = pole(-1), north = pole(1);
    Ring lower;
    for (unsigned i = 1; i < latitudes; ++i) {
        const double angle = std::numbers::pi * i / latitudes;
        const double out = std::sin(angle), up = -std::cos(angle);
        const auto outward = [&](const Vector& across) { return out * across + up * along; };
        const Ring higher = ring(builder, circle, solid.middle + (radius * up) * along,
                                 radius * out, solid.attitude, outward);
        if (i > 1)
            add_side(builder, lower, higher);
        else
            add_point_end(builder, higher, false, [&](std::size_t) { return south; });
        lower = higher;
    }
    add_point_end(builder, lower, true, [&](std::size_t) { return north; });
}

/// Adds a solid as a closed surface; measures of 0 become as thick as a line. Spheres have circles of
/// latitude at half as many angles as `circle` has corners.
void add_solid(MeshBuilder& builder, const Solid& solid, const Circle& circle,
               const Thickness& thickness) {
    const auto measure = [&](double size) {
        return std::max(size == 0 ? thickness.line : std::fabs(size), thickness.least);
    };
    const Vector size{measure(solid.size.x), measure(solid.size.y), measure(solid.size.z)};
    builder.paint(solid.paint);
    switch (solid.shape) {
        case SolidShape::box:
            return add_box(builder, solid, size);
        case SolidShape::cylinder:
            return add_cylinder(builder, solid, circle, size.x, size.y);
        case SolidShape::cone:
            return add_cone(builder, solid, circle, size.x, size.y);
        case SolidShape::sphere:
            return add_sphere(builder, solid, circle, size.x);
    }
}

/// How many triangles and, at most, corners such a solid has.
TubeSize solid_size(SolidShape shape, unsigned sides) {
    const std::uint64_t k = sides;
    switch (shape) {
        case SolidShape::box:
            return {12, 24, 8};
        case SolidShape::cylinder:
            return {4 * k - 4, 4 * k, 2 * k};
        case SolidShape::cone:
            return {2 * k - 2, 3 * k, k + 1};
        case SolidShape::sphere:
            break;
    }
    return {2 * k * (k / 2 - 1), k * (k / 2 - 1) + 2, k * (k / 2 - 1) + 2};
}

constexpr std::uint32_t none = 0xFFFFFFFF;
constexpr std::size_t most_smoothed = 64;

/// The points of a mesh by where they are; equal places are one point.
class Places {
public:
    Places(MeshBuilder& builder, std::size_t corners)
        : builder_(builder), slots_(std::bit_ceil(2 * corners + 1), none) {}

    std::uint32_t point(const Vector& v) {
        const Vector place{v.x + 0.0, v.y + 0.0, v.z + 0.0};  // -0 is 0
        std::uint64_t hash = 0;
        for (const double x : {place.x, place.y, place.z}) {
            hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29;
        }
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t i = hash & mask;; i = (i + 1) & mask) {
            if (slots_[i] == none) return slots_[i] = builder_.point(place);
            if (builder_.mesh.points[slots_[i]] == place) return slots_[i];
        }
    }

private:
    MeshBuilder& builder_;
    std::vector<std::uint32_t> slots_;
};

/// The polygons that meet in each point, and the corners they have made there.
class Meetings {
public:
    Meetings(std::span<const std::uint32_t> points, std::span<const std::uint32_t> owners,
             std::uint32_t first_point, std::size_t count)
        : first_point_(first_point),
          starts_(count + 1),
          faces_(points.size()),
          corners_(points.size(), none) {
        for (const std::uint32_t p : points) ++starts_[p - first_point + 1];
        for (std::size_t i = 0; i < count; ++i) starts_[i + 1] += starts_[i];
        std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
        for (std::size_t i = 0; i < points.size(); ++i)
            faces_[next[points[i] - first_point]++] = owners[i];
    }
    std::span<const std::uint32_t> faces(std::uint32_t point) const {
        const std::uint32_t at = point - first_point_;
        return std::span(faces_).subspan(starts_[at], starts_[at + 1] - starts_[at]);
    }
    std::span<std::uint32_t> corners(std::uint32_t point) {
        const std::uint32_t at = point - first_point_;
        return std::span(corners_).subspan(starts_[at], starts_[at + 1] - starts_[at]);
    }

private:
    std::uint32_t first_point_;
    std::vector<std::uint32_t> starts_, faces_, corners_;
};

/// Adds the polygons of a scene as triangles. Equal corners become one point. Where polygons of one
/// paint meet in a point and the angle between them has at least the cosine `crease`, they share
/// one normal there: the sum of theirs, each weighted by its area. Polygons without area are left out.
/// O(corners) expected time, at points where more than 64 polygons meet without smoothing.
class Sheets {
public:
    Sheets(MeshBuilder& builder, const Scene& scene, double crease, const Budget& budget)
        : builder_(builder), scene_(scene), crease_(crease), budget_(budget) {}

    void add() {
        const auto first_point = static_cast<std::uint32_t>(builder_.mesh.points.size());
        gather();
        Meetings meetings(points_, owners_, first_point, builder_.mesh.points.size() - first_point);
        std::vector<Vector> places;
        std::vector<std::uint32_t> corners;
        WorkCount faces("polygon of the mesh", scene_.faces.size());
        for (std::uint32_t f = 0; f < scene_.faces.size(); ++f) {
            if (f % 4096 == 0) budget_.check();
            faces.at(f);
            const std::uint32_t first = starts_[f], count = starts_[f + 1] - first;
            if (areas_[f] == Vector{}) continue;
            places.clear();
            for (std::uint32_t i = 0; i < count; ++i)
                places.push_back(builder_.mesh.points[points_[first + i]]);
            const auto triangles = polygon_triangles(places, budget_);
            if (triangles.empty()) continue;
            builder_.paint(scene_.faces[f].paint);
            corners.assign(count, none);
            for (const auto& triangle : triangles) {
                for (const std::uint32_t i : triangle)
                    if (corners[i] == none) corners[i] = corner(meetings, points_[first + i], f);
                builder_.triangle(corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]);
            }
        }
    }

private:
    /// Points of all polygons without repetitions next to each other, and their areas.
    void gather() {
        Places places(builder_, scene_.corners.size());
        std::vector<Vector> around;
        for (std::uint32_t f = 0; f < scene_.faces.size(); ++f) {
            if (f % 4096 == 0) budget_.check();
            const std::uint32_t first = static_cast<std::uint32_t>(points_.size());
            starts_.push_back(first);
            around.clear();
            for (const Vector& c : scene_.corners_of(scene_.faces[f])) {
                const std::uint32_t p = places.point(c);
                if (points_.size() > first && points_.back() == p) continue;
                points_.push_back(p);
            }
            while (points_.size() > first + 1 && points_.back() == points_[first])
                points_.pop_back();
            for (std::size_t i = first; i < points_.size(); ++i)
                around.push_back(builder_.mesh.points[points_[i]]);
            areas_.push_back(normal_of(around));
            owners_.resize(points_.size(), f);
        }
        starts_.push_back(static_cast<std::uint32_t>(points_.size()));
    }
    /// Twice the area, or that of the first triangle of what winds both ways.
    Vector normal_of(std::span<const Vector> around) const {
        const Vector whole = twice_area(around);
        if (length(whole) > 0) return whole;
        const auto triangles = polygon_triangles(around, budget_);
        if (triangles.empty()) return {};
        const auto& [a, b, c] = triangles.front();
        return cross(around[b] - around[a], around[c] - around[a]);
    }
    std::uint32_t corner(Meetings& meetings, std::uint32_t point, std::uint32_t face) {
        const Vector own = unit(areas_[face]);
        Vector normal = own;
        const auto faces = meetings.faces(point);
        if (faces.size() <= most_smoothed) {
            Vector sum;
            for (const std::uint32_t other : faces) {
                const Vector& area = areas_[other];
                if (dot(area, own) >= crease_ * length(area) && !(area == Vector{}))
                    sum = sum + area;
            }
            if (length(sum) > 0) normal = unit(sum);
        }
        for (std::uint32_t& known : meetings.corners(point)) {
            if (known == none) return known = builder_.corner(point, normal);
            const Mesh::Corner& c = builder_.mesh.corners[known];
            if (c.paint == builder_.current_paint() && dot(c.normal, normal) > 1 - 1e-12)
                return known;
            if (faces.size() > most_smoothed) break;
        }
        return builder_.corner(point, normal);
    }

    MeshBuilder& builder_;
    const Scene& scene_;
    double crease_;
    const Budget& budget_;
    std::vector<std::uint32_t> points_, owners_, starts_;  // corners of polygons as points
    std::vector<Vector> areas_;
};

void check(const Scene& scene, const MeshOptions& options) {
    if (options.facets < 3 || options.facets > 256)
        throw Error("a tube has 3 to 256 facets, found " + std::to_string(options.facets));
    if (!(options.crease >= 0 && options.crease <= 180))
        throw Error("a crease is an angle of 0 to 180 degrees");
    if (scene.empty()) throw Error(scene.name + " draws nothing");
    for (const Vector& corner : scene.corners)
        if (!is_finite(corner))
            throw Error(scene.name + " has a polygon that does not lie at finite coordinates");
    for (const Solid& solid : scene.solids)
        if (!is_finite(solid.middle) || !is_finite(solid.size))
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
    WorkCount parts("part of the mesh", limbs.limbs.size() + scene.solids.size());
    for (const Limb& limb : limbs.limbs) {
        if (steps++ % 1024 == 0) budget.check();
        parts.at(steps);
        if (!options.cylinders && is_cylinder(limbs, limb)) continue;
        add_tube(builder, limbs.nodes_of(limb), limb, scene, circle, crease);
    }
    for (const Solid& solid : scene.solids) {
        if (steps++ % 1024 == 0) budget.check();
        parts.at(steps);
        if (!options.solids) break;
        add_solid(builder, solid, finer, thick);
    }
    builder.mesh.closed = builder.mesh.triangles.size();
    Sheets(builder, scene, crease, budget).add();
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
