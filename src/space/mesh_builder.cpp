#include "space/mesh_builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace algae {

namespace {

auto key(const Paint& paint) {
    const Colour colour = paint.colour.value_or(Colour{});
    return std::tuple(paint.colour.has_value(), paint.index, colour.red, colour.green, colour.blue);
}

}  // namespace

Circle::Circle(unsigned sides) {
    for (unsigned k = 0; k < sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        parts_.emplace_back(std::cos(angle), std::sin(angle));
    }
}

void MeshBuilder::paint(const Paint& paint) {
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

std::uint32_t MeshBuilder::point(const Vector& place) {
    mesh.points.push_back(place);
    return static_cast<std::uint32_t>(mesh.points.size() - 1);
}

std::uint32_t MeshBuilder::corner(std::uint32_t point, const Vector& normal) {
    mesh.corners.push_back({point, paint_, normal});
    return static_cast<std::uint32_t>(mesh.corners.size() - 1);
}

void add_side(MeshBuilder& builder, const Ring& foot, const Ring& tip) {
    for (std::size_t k = 0; k < foot.size(); ++k) {
        const std::size_t next = k + 1 == foot.size() ? 0 : k + 1;
        builder.triangle(foot[k], foot[next], tip[next]);
        builder.triangle(foot[k], tip[next], tip[k]);
    }
}

void add_flat_end(MeshBuilder& builder, const Ring& ring, const Vector& normal, bool at_tip) {
    Ring corners;
    for (const std::uint32_t corner : ring)
        corners.push_back(builder.corner(builder.point_of(corner), normal));
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        if (at_tip)
            builder.triangle(corners[0], corners[k], corners[k + 1]);
        else
            builder.triangle(corners[0], corners[k + 1], corners[k]);
    }
}

void add_point_end(MeshBuilder& builder, const Ring& ring, std::uint32_t tip,
                   const std::vector<Vector>& normals, bool at_tip) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::size_t next = k + 1 == ring.size() ? 0 : k + 1;
        const std::uint32_t corner = builder.corner(tip, normals[k]);
        if (at_tip)
            builder.triangle(ring[k], ring[next], corner);
        else
            builder.triangle(ring[next], ring[k], corner);
    }
}

}  // namespace algae
