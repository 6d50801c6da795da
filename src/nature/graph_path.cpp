#include "nature/graph_path.hpp"

#include <algorithm>

#include "space/camera.hpp"

namespace algae {

std::vector<Point> graph_path(const std::vector<double>& values, double breadth) {
    if (values.empty()) return {};
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double scale = *high > *low ? 1 / (*high - *low) : 0;
    const double last = std::max<double>(static_cast<double>(values.size()) - 1, 1);
    std::vector<Point> points;
    points.reserve(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        points.push_back({breadth * static_cast<double>(i) / last, (values[i] - *low) * scale});
    return points;
}

Scene path_scene(const std::vector<Vector>& places, const Settings& settings) {
    Scene made;
    made.colours = settings.colours;
    for (std::uint32_t i = 1; i < places.size(); ++i) {
        Rod rod;
        rod.from = places[i - 1];
        rod.to = places[i];
        if (i > 1) rod.before = i - 2;
        made.rods.push_back(rod);
    }
    return made;
}

std::vector<Point> seen_path(const std::vector<Vector>& places) {
    SpaceBox box;
    for (const Vector& place : places) box.add(place);
    if (box.empty) return {};
    const Projection projection(Camera{}, box);
    std::vector<Point> points;
    points.reserve(places.size());
    for (const Vector& place : places) {
        const Seen seen = projection(place);
        points.push_back({seen.x, seen.y});
    }
    return points;
}

}  // namespace algae
