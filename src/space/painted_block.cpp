#include <array>
#include <cmath>

#include "space/scene_painter.hpp"

// Solids and polygons: facets that reach under their neighbours, and their edges.

namespace algae {

void ScenePainter::widen(const SeenFacet& facet, double pixel, bool of_solid,
                         std::vector<Point>& corners) {
    const std::size_t count = facet.corners.size();
    corners.clear();
    double area = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % count];
        area += a.x * b.y - a.y * b.x;
    }
    const double out = area < 0 ? -pixel : pixel;
    const auto normal = [&](std::size_t i) {
        const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % count];
        const double x = b.y - a.y, y = a.x - b.x, size = std::hypot(x, y);
        return size > 0 ? Point{x / size, y / size} : Point{0, 0};
    };
    for (std::size_t i = 0; i < count; ++i) {
        const Vector& corner = facet.corners[i];
        const std::size_t before = (i + count - 1) % count;
        const auto moved = [&](std::size_t edge) {
            switch (facet.adjoins[edge]) {
                case Adjoining::nothing:  // another solid may stand beside this
                    return of_solid ? overlap * out : 0;
                case Adjoining::later:
                case Adjoining::cut:
                    return (of_solid ? under : overlap) * out;
                case Adjoining::earlier:
                    break;
            }
            return 0.0;
        };
        const double p = moved(before), q = moved(i);
        Point at{corner.x, corner.y};
        if (p != 0 || q != 0) {
            // Where the two moved edges meet; at a sharp tip, the end of each.
            const Point m = normal(before), n = normal(i);
            const double sine = m.x * n.y - m.y * n.x;
            if (std::fabs(sine) > 0.7) {
                at.x += (p * n.y - q * m.y) / sine;
                at.y += (q * m.x - p * n.x) / sine;
            } else {
                corners.push_back({corner.x + p * m.x, corner.y + p * m.y});
                at.x += q * n.x;
                at.y += q * n.y;
            }
        }
        corners.push_back(at);
    }
}

void ScenePainter::paint_thing(const SeenBlock& block) {
    for (const SeenFacet& facet : block.facets) {
        if (facet.corners.size() < 3) continue;
        widen(facet, lit_.resolution, !block.flat, corners_);
        polygon(facet.colour, corners_);
        if (block.has_edges) paint_edges(facet);
    }
}

void ScenePainter::paint_edges(const SeenFacet& facet) {
    constexpr double shade = 0.75, breadth = 0.8, least = 8;  // in pixels: of an edge, its length
    const std::size_t count = facet.corners.size();
    const double pixel = lit_.resolution;
    const Colour dark{shade * facet.colour.red, shade * facet.colour.green,
                      shade * facet.colour.blue};
    double area = 0, shortest = INFINITY;
    for (std::size_t i = 0; i < count; ++i) {
        const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % count];
        area += a.x * b.y - a.y * b.x;
        shortest = std::min(shortest, std::hypot(b.x - a.x, b.y - a.y));
    }
    if (!(pixel > 0) || shortest < least * pixel) return;
    const double inward = (area < 0 ? -breadth : breadth) * pixel;
    for (std::size_t i = 0; i < count; ++i) {
        if (facet.adjoins[i] == Adjoining::cut) continue;
        const Vector &a = facet.corners[i], &b = facet.corners[(i + 1) % count];
        const double size = std::hypot(b.x - a.x, b.y - a.y);
        const double x = -inward * (b.y - a.y) / size, y = inward * (b.x - a.x) / size;
        polygon(dark, std::array{Point{a.x, a.y}, Point{b.x, b.y}, Point{b.x + x, b.y + y},
                                 Point{a.x + x, a.y + y}});
    }
}

}  // namespace algae
