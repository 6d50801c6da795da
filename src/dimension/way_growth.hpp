#pragma once

#include <cstddef>
#include <vector>

#include "base/budget.hpp"
#include "dimension/ratio_graph.hpp"
#include "exact/ball.hpp"
#include "exact/rational.hpp"

namespace algae {

/// The factor m by which the ways from the beginnings to the ends of figures of a ratio graph grow in
/// each generation: the spectral radius of the matrix that has, for each part outside branches, its
/// ratio turned by its heading.
///
/// By Gelfand's formula: for every power P of the matrix, |trace P| / size <= m^power <= |P|, and
/// repeated squaring brings both together.
class WayGrowth {
public:
    /// Throws Error where no turtle moves for ever, or where ways do not grow evenly (looked at in
    /// floating point), BoundReached where turns come back only after more than 1,000 generations
    /// or too many states move.
    explicit WayGrowth(const RatioGraph& graph, const Budget& budget = {});

    static constexpr std::size_t most_moving = 40;

    /// With a radius of at most 2^-bits. Throws Error where ways vanish.
    Ball enclosure(long bits) const;

private:
    struct Entry {
        std::size_t row, column;
        Expression ratio;
        Rational degrees;
    };
    void check_evenness() const;

    std::size_t size_ = 0;
    std::vector<std::vector<Entry>> levels_;  // until turns have come back twice
    std::size_t preperiod_ = 0, period_ = 1;
    std::vector<bool> moves_;  // by row: whether the state itself steps
    Budget budget_;
};

}  // namespace algae
