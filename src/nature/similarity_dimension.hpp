#pragma once

#include "dimension/exact_dimension.hpp"
#include "nature/iterated_functions.hpp"

namespace algae {

/// The similarity dimension of an iterated function system whose maps are similarities: the s for which
/// the sum of ratio^s is 1 (Moran 1946), with several states the matrix of these sums has the spectral
/// radius 1 (Mauldin and Williams 1988); of several components of states the largest. It is an upper
/// bound of the dimension of the attractor, and the dimension itself where the open set condition
/// holds. None, with the reason, where a map is no similarity.
ExactDimension similarity_dimension(const IteratedFunctions& system, const Budget& budget = {});

}  // namespace algae
