#pragma once

#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "nature/occupancy.hpp"
#include "turtle/canvas.hpp"

namespace algae {

/// Diffusion-limited aggregation without a grid: discs of diameter 1 in Brownian motion, one after
/// the other from far away, each staying where it first touches the cluster. The first one is the
/// seed, at the origin. Its dimension is about 1.71 (Tolman and Meakin, Physical Review A 40, 1989).
///
/// A disc jumps to a random point of the largest circle around it that is known to be free, as in
/// Muller's walk on spheres (Annals of Mathematical Statistics 27, 1956), and beyond the circle around
/// the cluster back to it (`return_to_circle`). Both are exact; a disc stays when it is closer than
/// `touching` to another one, and is moved on to it.
class FreeAggregate {
public:
    static constexpr double touching = 1e-4;

    /// The discs use random numbers by the seed and by how many came before them.
    FreeAggregate(std::uint64_t seed, const Budget& budget);

    /// Puts a disc into the cluster.
    void add(Point centre);
    /// Lets one disc walk until it stays; gives its centre. About the logarithm of the cluster's
    /// width in jumps. Throws BoundReached, Interrupted.
    Point grow();

    /// The centres, in the order in which they came.
    const std::vector<Point>& centres() const { return centres_; }
    /// The disc that each one came to touch; of the seed and of those that were put there, itself.
    const std::vector<std::uint32_t>& touched() const { return touched_; }
    /// Of the circle around all centres.
    double radius() const { return radius_; }

private:
    struct Nearest {
        std::uint32_t disc;
        double distance;
    };
    static constexpr double bin = 2;  // the width of the cells in which discs are looked up
    static std::int64_t cell_of(double coordinate);
    std::size_t index(std::int64_t x, std::int64_t y) const;
    Nearest nearest(Point place) const;
    void enter(std::uint32_t disc);
    void make_room(double reach);

    std::uint64_t seed_;
    Budget budget_;
    std::vector<Point> centres_;
    std::vector<std::uint32_t> touched_;
    std::vector<std::uint32_t> next_;   // the next disc of the same cell
    std::vector<std::uint32_t> first_;  // of each cell
    Occupancy occupancy_;
    double radius_ = 0;
};

}  // namespace algae
