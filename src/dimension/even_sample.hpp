#pragma once

#include <cstddef>
#include <cstdint>

#include "base/budget.hpp"
#include "dimension/points.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// How places are chosen along a length: one in each of equal stretches, which is the more even; or
/// each by itself, so that how far two of them are apart does not depend on how many there are.
enum class Spread { stretches, independent };

/// So many random points of what a figure draws, every place of its length as likely as any other, in
/// drawing order. What is drawn twice counts twice. The same for the same seed on every machine. The
/// figure is drawn twice; 32 bytes a point. `detail` is the figure's step.
///
/// Throws Error if nothing is drawn that has a length, BoundReached, Interrupted.
PointSet even_sample(const Figure& figure, std::size_t count, Spread spread, std::uint64_t seed,
                     const Budget& budget);

/// So many of the points at random, in their order; all of them if there are no more (selection
/// sampling: Knuth, The Art of Computer Programming 2, algorithm 3.4.2 S).
PointSet even_sample(const PointSet& points, std::size_t count, std::uint64_t seed);

}  // namespace algae
