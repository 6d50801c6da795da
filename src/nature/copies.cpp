#include "nature/copies.hpp"

#include <cmath>
#include <utility>

#include "base/error.hpp"

namespace algae {

namespace {

constexpr std::size_t most_copies = 1'000'000;
constexpr double flat = 1e-12;  // the share of its squared length that a flat polygon's area has

/// The polygon that a map makes of `corners`, or a line where it is flat.
Path image(const AffineMap& map, const std::vector<Point>& corners, std::uint32_t colour) {
    Path path;
    path.colour = colour;
    double area = 0, around = 0;
    for (const Point& corner : corners) path.points.push_back(map(corner));
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const Point a = path.points[i], b = path.points[(i + 1) % path.points.size()];
        area += a.x * b.y - a.y * b.x;
        around += std::hypot(b.x - a.x, b.y - a.y);
    }
    path.filled = std::fabs(area) > flat * around * around;
    if (!path.filled) path.points.push_back(path.points.front());
    return path;
}

}  // namespace

std::unique_ptr<PathFigure> copies(const IteratedFunctions& system, std::uint64_t generation,
                                   const Budget& budget) {
    struct Copy {
        AffineMap map;
        std::size_t state;
        std::uint32_t colour;
    };
    std::vector<Copy> made{{{}, 0, 0}};
    for (std::uint64_t round = 0; round < generation; ++round) {
        std::vector<Copy> next;
        for (const Copy& copy : made) {
            if ((next.size() & 0xfff) == 0) budget.check();
            for (std::size_t m = 0; m < system.maps.size(); ++m) {
                if (system.maps[m].from != copy.state) continue;
                next.push_back({composed(copy.map, system.maps[m].map), system.maps[m].to,
                                round == 0 ? static_cast<std::uint32_t>(m) : copy.colour});
            }
        }
        if (next.size() > most_copies)
            throw BoundReached(Bound::method,
                               system.name + ", generation " + std::to_string(round + 1) +
                                   ": has " + std::to_string(next.size()) +
                                   " copies, of which at most 1000000 can be drawn; its attractor, "
                                   "without `generation`, has no such bound");
        made = std::move(next);
    }
    std::vector<Path> paths;
    for (const Copy& copy : made) paths.push_back(image(copy.map, system.start, copy.colour));
    return std::make_unique<PathFigure>(std::move(paths), system.settings);
}

}  // namespace algae
