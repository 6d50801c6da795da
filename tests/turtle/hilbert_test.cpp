// The Hilbert curve in space: its points, its end, and its view from above.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <set>

#include "model/model.hpp"
#include "turtle/of_gallery.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

using Cell = std::array<double, 2>;
using Edges = std::set<std::array<Cell, 2>>;

std::array<Cell, 2> edge(Cell a, Cell b) { return a < b ? std::array{a, b} : std::array{b, a}; }

/// The edges moved so that their lowest corner is the origin.
Edges moved(const Edges& edges) {
    Cell low = (*edges.begin())[0];
    for (const auto& [a, b] : edges)
        for (std::size_t i = 0; i < 2; ++i) low[i] = std::min({low[i], a[i], b[i]});
    Edges out;
    for (const auto& [a, b] : edges)
        out.insert(edge({a[0] - low[0], a[1] - low[1]}, {b[0] - low[0], b[1] - low[1]}));
    return out;
}

/// The edges after one of the eight symmetries of the square.
Edges turned(const Edges& edges, int symmetry) {
    const auto image = [&](Cell a) {
        if (symmetry & 1) a[0] = -a[0];
        if (symmetry & 2) a[1] = -a[1];
        if (symmetry & 4) std::swap(a[0], a[1]);
        return a;
    };
    Edges out;
    for (const auto& [a, b] : edges) out.insert(edge(image(a), image(b)));
    return moved(out);
}

/// The strokes seen along an axis, but for those that point along it.
Edges seen_along(std::size_t axis, const Scene& scene) {
    const auto flat = [&](const Vector& point) {
        const std::array all{point.x, point.y, point.z};
        return Cell{all[(axis + 1) % 3], all[(axis + 2) % 3]};
    };
    Edges out;
    for (const Rod& rod : scene.rods)
        if (flat(rod.from) != flat(rod.to)) out.insert(edge(flat(rod.from), flat(rod.to)));
    return moved(out);
}

}  // namespace

TEST_CASE("the Hilbert curve in space visits all 8^n points once and ends below its start") {
    for (const char* name : {"hilbert-3d", "hilbert-3d-001"}) {
        const Model system = of_gallery(name);
        double side = 0;
        std::size_t points = 1;
        for (std::uint64_t n = 1; n <= 4; ++n) {
            side = 2 * side + 1;
            points *= 8;
            const SpaceDerivation found = scene(system, n, {});
            CHECK(found.facts.segments == points - 1);
            std::set<std::array<double, 3>> visited{{0, 0, 0}};
            for (const Rod& rod : found.scene.rods) {
                CHECK(length(rod.to - rod.from) == 1);  // exactly
                visited.insert({rod.to.x, rod.to.y, rod.to.z});
            }
            CHECK(visited.size() == points);
            CHECK(found.end.position == Vector{0, 0, -side});
            const double wide =
                side + (found.scene.solids.empty() ? 0 : 0.5);  // of cubes around points
            CHECK(found.facts.box.high - found.facts.box.low == Vector{wide, wide, wide});
            CHECK((found.scene.solids.empty() || found.scene.solids.size() == points));
            CHECK(found.facts.length == static_cast<double>(points - 1));
            const Trace trace = algae::trace(found, {});
            CHECK(trace.distinct_segments == points - 1);
            CHECK(trace.vertices == points);
        }
    }
}

TEST_CASE("from above the Hilbert curve in space is that of the plane, from the sides it is not") {
    const Model in_space = of_gallery("hilbert-3d"), plane = of_gallery("hilbert");
    std::size_t edges = 1;
    for (std::uint64_t n = 1; n <= 4; ++n) {
        edges *= 4;
        const Scene curve = scene(in_space, n, {}).scene;
        const Edges flat = seen_along(2, scene(plane, n, {}).scene), seen = seen_along(2, curve);
        CHECK(flat.size() == edges - 1);
        CHECK(seen.size() == edges - 1);
        int symmetries = 0;
        for (int symmetry = 0; symmetry < 8; ++symmetry)
            symmetries += turned(flat, symmetry) == seen;
        CHECK(symmetries > 0);
        if (n == 3) CHECK(seen_along(0, curve).size() == 77);
        if (n == 3) CHECK(seen_along(1, curve).size() == 91);
    }
}
