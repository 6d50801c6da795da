#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "nature/occupancy.hpp"
#include "rewrite/draws.hpp"

namespace algae {

/// A cell of the square grid.
struct GridCell {
    std::int32_t x = 0, y = 0;
    bool operator==(const GridCell&) const = default;
};

/// Diffusion-limited aggregation on the square grid (Witten and Sander, Physical Review Letters 47,
/// 1981). A particle walks from cell to cell, to each of the four neighbours with chance 1/4, until
/// one of these neighbours belongs to the cluster; there it stays. The first cell is the seed, (0,0).
///
/// With a region of r cells, particles begin on any free cell of the square |x|, |y| <= r around the
/// seed, the Moore neighbourhood of range r, all with the same chance; one that leaves the square is
/// lost and another begins. Without one, they come from far away: they begin on a circle around the
/// cluster, and where they go twice as far out, they come back to it where Brownian motion does.
///
/// What random numbers a particle uses depends on the seed of the numbers and on how many particles
/// were before it.
class GridAggregate {
public:
    /// Throws Error if the region is 0 or beyond 16383 cells.
    GridAggregate(std::uint64_t seed, std::optional<std::uint64_t> region, const Budget& budget);

    /// Puts a cell into the cluster. Throws Error if it is there already or outside of the region.
    void add(GridCell cell);
    /// Lets one particle walk until it stays, with jumps: from the middle of an empty square to where
    /// a walk leaves it (`square_exit_chance`), so that the chances are those of single steps. About
    /// the logarithm of the cluster's width in jumps. Throws Error if no cell of the region is free.
    GridCell grow();
    /// The same by single steps, as the algorithm is written; for regions only.
    GridCell grow_by_steps();

    /// In the order in which they came.
    const std::vector<GridCell>& cells() const { return cells_; }
    /// Whether some cell of the cluster is on the border of the region.
    bool fills_region() const;

private:
    bool touches(std::int64_t x, std::int64_t y) const;
    GridCell free_cell(const Draws& draws, std::uint64_t& number) const;
    GridCell on_circle(double angle) const;
    GridCell stay(std::int64_t x, std::int64_t y);
    void make_room(std::int64_t reach);

    std::uint64_t seed_;
    std::optional<std::int64_t> region_;
    Budget budget_;
    std::vector<GridCell> cells_;
    Occupancy occupancy_;
    std::int64_t extent_ = 0;  // the greatest |x| or |y|
    double radius_ = 0;        // of the circle around all cells
};

}  // namespace algae
