#pragma once

// Iterated function systems: their maps, what they draw, and what is known of them.

#include "nature/detail/figures.hpp"

namespace algae {

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

/// For each two states whether maps lead from the first to the second. O(states^3).
std::vector<std::vector<bool>> reachable(const IteratedFunctions& system);

/// For each state a box that holds its attractor, hardly larger than need be. By supporting lines
/// in 720 directions: how far a set reaches in a direction is how far its images reach, and each
/// round makes the bounds of all directions tighter.
std::vector<Box> attractor_boxes(const IteratedFunctions& system);

/// Sends points of the attractor of the first state such that each point of it lies within
/// `accuracy` of one of them; the colour is the number of the map. O(cells of the size that needs *
/// maps), however the images overlap; a bit for each of these cells.
///
/// Throws BoundReached if the bits need more memory than the budget has.
void send_attractor(const IteratedFunctions& system, double accuracy, const TakeDots& take,
                    const Budget& budget);

/// The attractor, to twice the resolution with which it is drawn (a third of a pixel in pictures);
/// without one, to a part in 1024 of its longer side. How many points there are is not known
/// before.
std::unique_ptr<Figure> attractor_figure(const IteratedFunctions& system);

/// The points x_1, ..., x_count of the chaos game (a random iterated function system): x_t is the
/// image of x_(t-1) under a map picked at random with its chance; its colour is the number of the
/// map. They are made again whenever they are drawn, from the seed, so 10^8 of them take no memory.
///
/// Throws Error if the system has several states: there is no such game.
std::unique_ptr<PointFigure> chaos_game(const IteratedFunctions& system, std::uint64_t count,
                                        const Budget& budget);

/// What a multiple reduction copy machine makes of the start polygon in `generation` rounds: A_0 is
/// the polygon, A_(n+1) the union of the images of A_n under the maps. Flat images are drawn as
/// lines.
///
/// Throws BoundReached if there are more than a million copies.
std::unique_ptr<PathFigure> copies(const IteratedFunctions& system, std::uint64_t generation,
                                   const Budget& budget);

/// How the parts of an attractor of similarities lie: so that the open set condition holds, or with
/// two that are one and the same.
enum class Separation { apart, coincide, unknown };

/// Of the parts within a strongly connected component of states. For maps whose numbers lie in the
/// field of the rational numbers and a root of unity (`CyclotomicField`): turns by rational numbers
/// of degrees, square roots of rational numbers; where at most `most` neighbour maps decide it.
Separation separation(const IteratedFunctions& system, const std::vector<std::size_t>& states,
                      const Budget& budget, std::size_t most = 20'000);

/// The ratio of a map that is a similarity: as it is written, or where its numbers, exactly, make it
/// one.
std::optional<Expression> exact_ratio(const IteratedFunctions::Map& map);

/// The similarity dimension of an iterated function system whose maps are similarities: the s for
/// which the sum of ratio^s is 1 (Moran 1946), with several states the matrix of these sums has the
/// spectral radius 1 (Mauldin and Williams 1988); of several components of states the largest. It
/// is an upper bound of the dimension of the attractor, and the dimension itself where the open set
/// condition holds. None, with the reason, where a map is not a similarity.
ExactDimension similarity_dimension(const IteratedFunctions& system, const Budget& budget = {});

/// The dimensions of a self-affine carpet (Bedford 1984, McMullen 1984): all maps make a rectangle smaller by m one way and by n > m
/// the other way, without a turn, into cells of the same grid. Nothing where they do not.
std::optional<ExactDimension> carpet_dimension(const IteratedFunctions& system);

}  // namespace algae
