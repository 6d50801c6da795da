#include "turtle/detail/mesh.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "turtle/any_scene.hpp"

using namespace algae;

namespace {

double twice_sum(const std::vector<Vector>& corners,
                 const std::vector<std::array<std::uint32_t, 3>>& found) {
    const Vector whole = twice_area(corners);
    const Vector up = (1 / length(whole)) * whole;
    double sum = 0;
    for (const auto& [a, b, c] : found) {
        const double part = dot(up, cross(corners[b] - corners[a], corners[c] - corners[a]));
        CHECK(part > 0);
        sum += part;
    }
    return sum;
}

/// Whether the triangles fill the polygon: none against it, and their areas add up.
bool fills(const std::vector<Vector>& corners) {
    const auto found = polygon_triangles(corners, Budget());
    const double whole = length(twice_area(corners));
    return std::fabs(twice_sum(corners, found) - whole) < 1e-9 * whole;
}

/// A polygon around the origin, each corner at its own distance: concave in many places.
std::vector<Vector> star(const std::vector<double>& distances, const Vector& across,
                         const Vector& up) {
    std::vector<Vector> corners;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const Turn turn =
            turn_by(360.0 * static_cast<double>(i) / static_cast<double>(distances.size()));
        corners.push_back(distances[i] * (turn.cosine * across + turn.sine * up));
    }
    return corners;
}

}  // namespace

TEST_CASE("concave polygons in any plane are filled") {
    CHECK(rc::check("random stars", [] {
        std::vector<double> distances;
        for (int i = *rc::gen::inRange(3, 40); i > 0; --i) distances.push_back(any_number(0.1, 1));
        const Vector normal = any_direction();
        Vector across =
            cross(normal, std::fabs(normal.x) < 0.8 ? Vector{1, 0, 0} : Vector{0, 1, 0});
        across = (1 / length(across)) * across;
        std::vector<Vector> corners = star(distances, across, cross(normal, across));
        if (*rc::gen::inRange(0, 2)) std::reverse(corners.begin(), corners.end());
        RC_ASSERT(fills(corners));
        RC_ASSERT(polygon_triangles(corners, Budget()).size() == corners.size() - 2);
    }));
}

TEST_CASE("corners on straight sides make no degenerate triangle") {
    std::vector<Vector> square;
    for (int i = 0; i < 4; ++i) square.push_back({i / 4.0, 0, 0});
    for (int i = 0; i < 4; ++i) square.push_back({1, i / 4.0, 0});
    for (int i = 4; i > 0; --i) square.push_back({i / 4.0, 1, 0});
    for (int i = 4; i > 0; --i) square.push_back({0, i / 4.0, 0});
    CHECK(fills(square));
    CHECK(polygon_triangles(square, Budget()).size() == 14);
    CHECK(
        polygon_triangles(std::vector<Vector>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, Budget()).empty());
}

TEST_CASE("combs, spirals and holes reached by a slit") {
    std::vector<Vector> comb{{0, -1, 0}};
    for (int i = 0; i < 50; ++i) {
        comb.push_back({i + 0.0, 0, 0});
        comb.push_back({i + 0.5, 9, 0});
    }
    comb.push_back({50, -1, 0});
    CHECK(fills(comb));
    std::vector<Vector> spiral;
    for (int i = 0; i <= 200; ++i)
        spiral.push_back({i * std::cos(i / 9.0), i * std::sin(i / 9.0), 0});
    for (int i = 200; i >= 20; --i)
        spiral.push_back({(i - 5) * std::cos(i / 9.0), (i - 5) * std::sin(i / 9.0), 0});
    CHECK(fills(spiral));
    CHECK(fills({{0, 0, 0},
                 {4, 0, 0},
                 {4, 4, 0},
                 {0, 4, 0},
                 {0, 0, 0},
                 {1, 1, 0},
                 {1, 3, 0},
                 {3, 3, 0},
                 {3, 1, 0},
                 {1, 1, 0}}));
}

TEST_CASE("sides that cross and polygons that are not plane give triangles with area") {
    CHECK(rc::check("random corners", [] {
        std::vector<Vector> corners;
        for (int i = *rc::gen::inRange(0, 20); i > 0; --i)
            corners.push_back({any_number(-2, 2), any_number(-2, 2),
                               *rc::gen::inRange(0, 2) ? any_number(-1, 1) : 0});
        for (const auto& [a, b, c] : polygon_triangles(corners, Budget()))
            RC_ASSERT(length(cross(corners[b] - corners[a], corners[c] - corners[a])) > 0);
    }));
    const std::vector<Vector> eight{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}};
    CHECK(!polygon_triangles(eight, Budget()).empty());
}

TEST_CASE("a curve of many corners is triangulated at once") {
    std::vector<double> distances;
    for (int i = 0; i < 100000; ++i) distances.push_back(i % 2 ? 1 : 0.9995);
    CHECK(fills(star(distances, {1, 0, 0}, {0, 1, 0})));
}
