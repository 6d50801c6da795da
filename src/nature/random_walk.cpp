#include "nature/random_walk.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "nature/gaussian.hpp"

namespace algae {

std::vector<Vector> random_walk(const RandomWalk& walk, const Budget& budget) {
    if (walk.dimensions < 1 || walk.dimensions > 3)
        throw Error("dimensions: expected 1, 2 or 3, found " + std::to_string(walk.dimensions));
    if (!(walk.deviation > 0) || !std::isfinite(walk.deviation))
        throw Error("deviation: expected a number above 0, found " +
                    std::to_string(walk.deviation));
    if (walk.steps >= budget.memory / sizeof(Vector))
        throw BoundReached(Bound::memory, "a walk of " + std::to_string(walk.steps) +
                                              " steps takes more memory than the " +
                                              std::to_string(budget.memory) + " bytes allowed" +
                                              budget.by(Bound::memory) + "; use fewer steps");
    const Gaussians across(walk.seed, 0), along(walk.seed, 1), upward(walk.seed, 2);
    std::vector<Vector> places(walk.steps + 1);
    for (std::uint64_t t = 0; t < walk.steps; ++t) {
        if (t % 4096 == 0) budget.check();
        const double y = walk.dimensions > 1 ? along.at(t) : 0;
        const double z = walk.dimensions > 2 ? upward.at(t) : 0;
        places[t + 1] = places[t] + walk.deviation * Vector{across.at(t), y, z};
    }
    return places;
}

}  // namespace algae
