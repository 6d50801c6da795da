#pragma once

#include <cstddef>
#include <vector>

#include "base/budget.hpp"
#include "dimension/neighbours.hpp"
#include "exact/integer.hpp"
#include "growth/rate.hpp"

namespace algae {

/// How fast the different parts of a component multiply where parts coincide.
struct DistinctGrowth {
    Rate rate = Rate(1);
    std::size_t kinds = 0;  // of surroundings, that were told apart
    /// How many different parts of each of the first levels the component's first piece has, itself
    /// being that of level 0.
    std::vector<Integer> first_counts;
};

/// Parts are told apart by their surroundings: the other parts near them that may still coincide
/// with them in some level below. There are finitely many kinds, and what surrounds the parts of a
/// part follows from what surrounds it; a part that k parts share counts 1/k for each of them. The
/// growth of the number of different parts is the spectral radius of this matrix (Ngai and Wang,
/// Hausdorff dimension of self-similar sets with overlaps, 2001, for sets of finite type), and the
/// dimension of the component is its logarithm over log |mu|. Throws BoundReached beyond `most` kinds.
DistinctGrowth distinct_growth(const RecurrentSet& set, std::size_t component,
                               const Neighbours& neighbours, const Budget& budget = {},
                               std::size_t most = 50'000);

}  // namespace algae
