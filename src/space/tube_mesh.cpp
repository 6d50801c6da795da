#include "space/tube_mesh.hpp"

#include <cmath>
#include <numbers>

namespace algae {

namespace {

Vector unit(const Vector& v) { return (1 / length(v)) * v; }

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
        for (std::size_t k = 0; k < corner_ring.size(); ++k) {
            const std::size_t next = k + 1 == corner_ring.size() ? 0 : k + 1;
            if (at_tip)
                builder_.triangle(corner_ring[k], corner_ring[next], pole);
            else
                builder_.triangle(corner_ring[next], corner_ring[k], pole);
        }
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

}  // namespace

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

}  // namespace algae
