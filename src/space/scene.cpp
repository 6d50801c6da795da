#include "space/scene.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace algae {

namespace {

/// The half sides of the box along the axes around a solid centred at the origin.
Vector reach(const Solid& solid) {
    const auto extent = [&](double heading, double left, double up) {
        const double x = heading * solid.size.x / 2, y = left * solid.size.y / 2, z = up * solid.size.z / 2;
        switch (solid.shape) {
            case SolidShape::box:
                return std::fabs(x) + std::fabs(y) + std::fabs(z);
            case SolidShape::cylinder:
            case SolidShape::cone:  // the disc of its base reaches as far as a cylinder's; its tip less
                return std::fabs(x) + solid.size.y * std::sqrt(std::max(0.0, 1 - heading * heading));
            case SolidShape::sphere:
                break;
        }
        return solid.size.x;
    };
    const Vector &h = solid.attitude.heading(), &l = solid.attitude.left(), &u = solid.attitude.up();
    return {extent(h.x, l.x, u.x), extent(h.y, l.y, u.y), extent(h.z, l.z, u.z)};
}

}  // namespace

void SpaceBox::add(const Vector& point) {
    if (empty) {
        low = high = point;
        empty = false;
        return;
    }
    low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
}

void SpaceBox::add(const SpaceBox& box) {
    if (box.empty) return;
    add(box.low);
    add(box.high);
}

double SpaceBox::diagonal() const { return length(high - low); }

void Scene::add_face(std::span<const Vector> points, const Paint& paint) {
    if (corners.size() + points.size() > std::numeric_limits<std::uint32_t>::max())
        throw BoundReached(name + " has more than 2^32 corners of polygons");
    faces.push_back({static_cast<std::uint32_t>(corners.size()), static_cast<std::uint32_t>(points.size()), paint});
    corners.insert(corners.end(), points.begin(), points.end());
}

SpaceBox box_of(const Scene& scene) {
    SpaceBox box;
    for (const Rod& rod : scene.rods) {
        box.add(rod.from);
        box.add(rod.to);
    }
    for (const Vector& corner : scene.corners) box.add(corner);
    for (const Solid& solid : scene.solids) {
        const Vector half = reach(solid);
        box.add(solid.middle - half);
        box.add(solid.middle + half);
    }
    return box;
}

double total_length(const Scene& scene) {
    double sum = 0;
    for (const Rod& rod : scene.rods) sum += length(rod.to - rod.from);
    return sum;
}

}  // namespace algae
