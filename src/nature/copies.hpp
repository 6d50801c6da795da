#pragma once

#include <cstdint>
#include <memory>

#include "nature/iterated_functions.hpp"
#include "nature/path_figure.hpp"

namespace algae {

/// What a multiple reduction copy machine makes of the start polygon in `generation` rounds: A_0 is the
/// polygon, A_(n+1) the union of the images of A_n under the maps. Flat images are drawn as lines.
///
/// Throws BoundReached if there are more than a million copies.
std::unique_ptr<PathFigure> copies(const IteratedFunctions& system, std::uint64_t generation,
                                   const Budget& budget);

}  // namespace algae
