#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nature/link_figure.hpp"
#include "nature/relative.hpp"

namespace algae {

/// Pictures of one cluster of diffusion-limited aggregation as it grows. Each particle is drawn joined
/// to the one that it came to touch, in the colours of the list from the oldest to the youngest.
class Aggregates : public Relative {
public:
    std::vector<std::uint64_t> particles{10000};  // a figure for each, with the seed
    std::uint64_t seed = 1;
    bool off_lattice = false;             // discs instead of cells of a grid
    std::optional<std::uint64_t> region;  // of the grid; none: particles come from far away
    bool by_steps = false;                // instead of jumps; in a region
    bool stop_at_border = true;           // of the region: not all particles may come then

    static constexpr std::uint64_t most = 100'000'000;

    /// Throws Error on parameters out of range or that do not fit together.
    void check() const;
    /// Particle by particle: from the one touched to its own place. The first is the seed. The last
    /// answer is kept. Throws BoundReached, Interrupted.
    const std::vector<Link>& links(std::uint64_t count, const Budget& budget) const;

    std::vector<RelativeFigure> figures(const Budget& budget) const override;
    std::vector<RelativeFact> facts(const Budget& budget) const override;

private:
    std::vector<Link> grown(std::uint64_t count, const Budget& budget) const;

    mutable std::vector<Link> kept_;
    mutable std::uint64_t kept_count_ = 0;
};

/// The dimension that the radius of gyration of a growing cluster gives: the slope of the logarithm of
/// the number of particles against that of the radius, by least squares over the last `doublings`
/// doublings of the number. Nothing with fewer than 3 of them. O(links).
std::optional<double> gyration_dimension(const std::vector<Link>& links, std::size_t doublings);

}  // namespace algae
