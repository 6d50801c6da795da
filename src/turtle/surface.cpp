#include "turtle/surface.hpp"

#include <algorithm>
#include <array>

namespace algae {

namespace {

using Outline = std::vector<Vector>;

Vector place(const Triple& point) { return {point.x.value, point.y.value, point.z.value}; }

/// The cubic Bernstein polynomials.
std::array<double, 4> weights(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

/// An outline that is the same on both sides of the heading: a cubic Bezier curve from the turtle to
/// the tip and its mirror image.
Outline mirrored(const std::array<Vector, 4>& side) {
    constexpr int parts = 12;
    Outline out;
    for (int i = 0; i <= parts; ++i) {
        const auto weight = weights(static_cast<double>(i) / parts);
        Vector point;
        for (std::size_t k = 0; k < 4; ++k) point = point + weight[k] * side[k];
        out.push_back(point);
    }
    for (int i = parts - 1; i > 0; --i) {
        const Vector& point = out[static_cast<std::size_t>(i)];
        out.push_back({point.x, -point.y, point.z});
    }
    return out;
}

Outline disc() {
    constexpr int corners = 32;
    Outline out;
    for (int i = 0; i < corners; ++i) {
        const Turn turn = turn_by(360.0 * i / corners);
        out.push_back({turn.cosine / 2, turn.sine / 2, 0});
    }
    return out;
}

std::vector<Outline> patch(const std::vector<Triple>& points) {
    constexpr int parts = 6;
    const auto at = [&](int row, int column) {
        const auto across = weights(static_cast<double>(column) / parts),
                   along = weights(static_cast<double>(row) / parts);
        Vector point;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                point = point + along[i] * across[j] * place(points[4 * i + j]);
        return point;
    };
    std::vector<Outline> out;
    for (int row = 0; row < parts; ++row)
        for (int column = 0; column < parts; ++column) {
            const Vector a = at(row, column), b = at(row + 1, column), c = at(row + 1, column + 1),
                         d = at(row, column + 1);
            out.push_back({a, b, c});
            out.push_back({a, c, d});
        }
    return out;
}

}  // namespace

std::vector<std::vector<Vector>> surface_faces(const SurfaceSetting& surface) {
    if (surface.kind == "leaf")
        return {mirrored({Vector{}, {0.2, 0.8 / 3, 0}, {0.6, 0.8 / 3, 0}, {1, 0, 0}})};
    if (surface.kind == "petal")
        return {mirrored({Vector{}, {0.5, 0.19, 0}, {1, 0.57, 0}, {1, 0, 0}})};
    if (surface.kind == "disc") return {disc()};
    if (surface.kind == "patch") return patch(surface.points);
    Outline corners;
    for (const Triple& point : surface.points) corners.push_back(place(point));
    return {corners};
}

bool is_flat(const SurfaceSetting& surface) {
    return std::all_of(surface.points.begin(), surface.points.end(),
                       [](const Triple& point) { return point.z.value == 0; });
}

}  // namespace algae
