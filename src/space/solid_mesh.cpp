#include "space/solid_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace algae {

namespace {

Vector unit(const Vector& v) { return (1 / length(v)) * v; }

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
    std::vector<Vector> normals;  // at the tip, that of the middle of each side
    for (unsigned k = 0; k < circle.sides(); ++k) {
        const auto& a = builder.mesh.corners[foot[k]];
        const auto& b = builder.mesh.corners[foot[(k + 1) % circle.sides()]];
        normals.push_back(unit(a.normal + b.normal));
    }
    add_point_end(builder, foot, builder.point(solid.middle + half), normals, true);
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
            for (std::size_t k = 0; k < higher.size(); ++k)
                builder.triangle(higher[(k + 1) % higher.size()], higher[k], south);
        lower = higher;
    }
    for (std::size_t k = 0; k < lower.size(); ++k)
        builder.triangle(lower[k], lower[(k + 1) % lower.size()], north);
}

}  // namespace

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

}  // namespace algae
