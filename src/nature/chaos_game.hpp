#pragma once

#include <cstdint>
#include <memory>

#include "nature/iterated_functions.hpp"
#include "nature/point_figure.hpp"

namespace algae {

/// The points x_1, ..., x_count of the chaos game (a random iterated function system): x_t is the image
/// of x_(t-1) under a map picked at random with its chance; its colour is the number of the map. They
/// are made again whenever they are drawn, from the seed, so 10^8 of them take no memory.
///
/// Throws Error if the system has several states: there is no such game.
std::unique_ptr<PointFigure> chaos_game(const IteratedFunctions& system, std::uint64_t count,
                                        const Budget& budget);

}  // namespace algae
