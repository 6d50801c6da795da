#pragma once

#include "turtle/canvas.hpp"

namespace algae {

/// The affine map (x,y) -> (a x + b y + e, c x + d y + f) of the plane.
struct AffineMap {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    Point operator()(Point p) const { return {a * p.x + b * p.y + e, c * p.x + d * p.y + f}; }
    bool operator==(const AffineMap&) const = default;
};

/// First `inner`, then `outer`.
///
/// Example: composed({2, 0, 0, 2, 0, 0}, {1, 0, 0, 1, 3, 4})(Point{}) == Point{6, 8}
AffineMap composed(const AffineMap& outer, const AffineMap& inner);

/// The greatest factor by which it stretches a distance: the largest singular value of its matrix.
///
/// Example: norm(AffineMap{0.25, 0, 0, -0.5, 7, 7}) == 0.5
double norm(const AffineMap& map);
/// The least such factor.
double least_stretch(const AffineMap& map);
/// The factor by which it multiplies areas; negative where it reflects.
double determinant(const AffineMap& map);

/// The point that it maps to itself. Of a map whose norm is below 1; others may have none, and give
/// what is no number.
///
/// Example: fixed_point(AffineMap{0.5, 0, 0, 0.5, 1, 2}) == Point{2, 4}
Point fixed_point(const AffineMap& map);

}  // namespace algae
