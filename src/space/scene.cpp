#include "space/scene.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace algae {

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
        throw BoundReached(Bound::method, name + " has more than 2^32 corners of polygons");
    faces.push_back({static_cast<std::uint32_t>(corners.size()),
                     static_cast<std::uint32_t>(points.size()), paint});
    corners.insert(corners.end(), points.begin(), points.end());
}

SpaceBox box_of(const Solid& solid) {
    const Vector &h = solid.attitude.heading(), &l = solid.attitude.left(),
                 &u = solid.attitude.up();
    const Vector ahead = (solid.size.x / 2) * h;
    SpaceBox box;
    const auto add_around = [&](const Vector& middle, const Vector& half) {
        box.add(middle - half);
        box.add(middle + half);
    };
    // A disc across the heading reaches as far along an axis as its radius times the sine of the
    // angle between the two.
    const Vector disc =
        solid.size.y * Vector{std::hypot(l.x, u.x), std::hypot(l.y, u.y), std::hypot(l.z, u.z)};
    switch (solid.shape) {
        case SolidShape::box: {
            const Vector aside = (solid.size.y / 2) * l, above = (solid.size.z / 2) * u;
            const auto sum = [](double x, double y, double z) {
                return std::fabs(x) + std::fabs(y) + std::fabs(z);
            };
            add_around(solid.middle,
                       {sum(ahead.x, aside.x, above.x), sum(ahead.y, aside.y, above.y),
                        sum(ahead.z, aside.z, above.z)});
            break;
        }
        case SolidShape::cylinder:
            add_around(solid.middle + ahead, disc);
            add_around(solid.middle - ahead, disc);
            break;
        case SolidShape::cone:
            box.add(solid.middle + ahead);
            add_around(solid.middle - ahead, disc);
            break;
        case SolidShape::sphere:
            add_around(solid.middle, {solid.size.x, solid.size.x, solid.size.x});
            break;
    }
    return box;
}

SpaceBox box_of(const Scene& scene) {
    SpaceBox box;
    for (const Rod& rod : scene.rods) {
        box.add(rod.from);
        box.add(rod.to);
    }
    for (const Vector& corner : scene.corners) box.add(corner);
    for (const Solid& solid : scene.solids) box.add(box_of(solid));
    return box;
}

double total_length(const Scene& scene) {
    double sum = 0;
    for (const Rod& rod : scene.rods) sum += length(rod.to - rod.from);
    return sum;
}

}  // namespace algae
