#pragma once

#include <cstdint>
#include <vector>

#include "nature/random_walk.hpp"
#include "nature/relative.hpp"

namespace algae {

/// Pictures of the beginnings of one random walk: in one dimension its graph against time, in two its
/// path, in three its path as the usual camera sees it.
class RandomWalks : public Relative {
public:
    RandomWalk walk;                          // `steps` is not used
    std::vector<std::uint64_t> steps{10000};  // a figure for each

    /// Throws Error on a walk out of range or without steps.
    void check() const;

    std::vector<RelativeFigure> figures(const Budget& budget) const override;
    std::vector<RelativeFact> facts(const Budget& budget) const override;
    std::optional<Scene> scene(const Budget& budget) const override;
};

}  // namespace algae
