#include "nature/affine_map.hpp"

#include <cmath>

namespace algae {

AffineMap composed(const AffineMap& outer, const AffineMap& inner) {
    const Point shift = outer({inner.e, inner.f});
    return {outer.a * inner.a + outer.b * inner.c,
            outer.a * inner.b + outer.b * inner.d,
            outer.c * inner.a + outer.d * inner.c,
            outer.c * inner.b + outer.d * inner.d,
            shift.x,
            shift.y};
}

// With the parts that keep and that reverse directions of the matrix, of sizes p and q, the singular
// values are p + q and |p - q|.
double norm(const AffineMap& map) {
    return (std::hypot(map.a + map.d, map.c - map.b) + std::hypot(map.a - map.d, map.c + map.b)) /
           2;
}

double least_stretch(const AffineMap& map) {
    return std::fabs(std::hypot(map.a + map.d, map.c - map.b) -
                     std::hypot(map.a - map.d, map.c + map.b)) /
           2;
}

double determinant(const AffineMap& map) { return map.a * map.d - map.b * map.c; }

Point fixed_point(const AffineMap& map) {
    const double p = 1 - map.a, q = 1 - map.d, det = p * q - map.b * map.c;
    return {(q * map.e + map.b * map.f) / det, (map.c * map.e + p * map.f) / det};
}

}  // namespace algae
