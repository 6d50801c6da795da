#include "space/seen_solid.hpp"

#include <array>
#include <cmath>

namespace algae {

namespace {

Vector unit(const Vector& way) {
    const double size = length(way);
    return size > 0 ? (1 / size) * way : way;
}

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

/// The vector area of a polygon, doubled (Newell).
Vector doubled_area(std::span<const Vector> corners) {
    Vector sum;
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum = sum + cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return sum;
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
        const Vector outward = doubled_area(facet.corners);
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
    Vector normal = unit(doubled_area(corners));
    if (dot(normal, projection.to_camera(middle)) < 0) normal = -1.0 * normal;
    const Seen at = projection(middle);
    facet.colour = lighting(colour, normal, at.depth);
    const Vector outward = unit(doubled_area(facet.corners));
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
