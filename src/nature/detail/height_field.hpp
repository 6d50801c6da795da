#pragma once

// Surfaces over a square, and their contour lines.

#include "nature/detail/random.hpp"

namespace algae {

/// Heights over the points of a square grid on [0, 1] x [0, 1], row by row from y = 0.
struct HeightField {
    std::size_t side = 0;  // points along an edge
    std::vector<double> heights;

    double at(std::size_t column, std::size_t row) const { return heights[row * side + column]; }
    double& at(std::size_t column, std::size_t row) { return heights[row * side + column]; }
    /// The distance between neighbours.
    double spacing() const { return 1 / static_cast<double>(side - 1); }
};

/// Throws Error as `check_parameters` does, or for more than `most_surface_levels`.
void check_surface(const BrownianMotion& surface);

/// A surface by displacing midpoints of squares (Fournier, Fussell and Carpenter 1982), in two half
/// steps a level. The displacement of half step k has the variance sigma^2 2^(-H k) (1 - 2^(2H -
/// 2)), so that of a level falls as that of a path does; the corners have sigma^2. Surfaces with
/// fewer levels and the same numbers are its coarser versions. O(4^levels).
///
/// Throws Error on parameters out of range, BoundReached, Interrupted.
///
/// Example: diamond_square({0.7, 1, 3}, Gaussians(1, 0), Budget()).side == 9
HeightField diamond_square(const BrownianMotion& surface, const Gaussians& numbers,
                           const Budget& budget);

/// A surface with exactly the distribution of fractional Brownian motion of the plane, up to
/// rounding: Gaussian, with mean 0, height 0 at (0, 0), and var(X(p) - X(q)) = sigma^2 |p - q|^(2H)
/// (Stein, Fast and exact simulation of fractional Brownian surfaces, J. Comput. Graph. Stat. 11,
/// 2002). O(levels * 4^levels), with 16 times the memory of the surface, 64 times for H > 3/4.
///
/// Throws Error on parameters out of range, BoundReached, Interrupted.
///
/// Example: exact_surface({0.7, 1, 3}, Gaussians(1, 0), Budget()).at(0, 0) == 0
HeightField exact_surface(const BrownianMotion& surface, const Gaussians& numbers,
                          const Budget& budget);

/// The height below which this share of the points lies: 0 gives the lowest height, 1 the highest.
///
/// Throws Error unless 0 <= share <= 1.
double height_at_share(const HeightField& field, double share);

/// The lines on which a surface has this height, in the unit square (marching squares: Lorensen and
/// Cline, Computer Graphics 21, 1987, for cubes). Lines that close end where they begin; others
/// begin and end at the border. What is not below lies to their left. O(points).
///
/// Throws BoundReached, Interrupted.
std::vector<Stroke> contour_lines(const HeightField& field, double height, const Budget& budget);

}  // namespace algae
