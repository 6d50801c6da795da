#pragma once

// Clusters that grow by diffusion, on the square grid and off it.

#include <bit>

#include "nature/nature.hpp"
#include "rewrite/rewrite.hpp"

namespace algae {

/// Cells of a square grid that are taken, and how far from any of them a place is: at once, by
/// looking at grids of cells 1, 2, 4, ... wide. Coordinates are from -half() up to half() - 1.
class Occupancy {
public:
    /// Nothing taken; half() is this power of two. Throws BoundReached if it takes more memory
    /// than the budget has: about a third of a byte for each cell.
    Occupancy(int half_exponent, const Budget& budget);

    std::int64_t half() const { return half_; }
    bool inside(std::int64_t x, std::int64_t y) const {
        return x >= -half_ && x < half_ && y >= -half_ && y < half_;
    }
    /// Marks a cell inside as taken. O(levels), and less where cells close by are taken.
    void take(std::int64_t x, std::int64_t y);
    bool taken(std::int64_t x, std::int64_t y) const {
        return bit(taken_[0], index(0, x + half_, y + half_));
    }
    /// Whether one of the 3 by 3 cells around a cell inside is taken.
    bool near(std::int64_t x, std::int64_t y) const {
        return bit(near_[0], index(0, x + half_, y + half_));
    }
    /// The greatest e such that no cell is taken within 2^e cells in both directions, by what the
    /// grids show: they may be up to twice as wide. `hint`, the last answer, makes it faster. For a
    /// cell inside that is not `near`; O(levels) at most.
    int empty_exponent(std::int64_t x, std::int64_t y, int hint) const;

private:
    using Bits = std::vector<std::uint64_t>;
    static bool bit(const Bits& bits, std::size_t at) { return bits[at >> 6] >> (at & 63) & 1; }
    static void set(Bits& bits, std::size_t at) { bits[at >> 6] |= std::uint64_t{1} << (at & 63); }
    std::size_t index(int level, std::int64_t column, std::int64_t row) const {
        return (static_cast<std::size_t>(row >> level) << (exponent_ + 1 - level)) +
               static_cast<std::size_t>(column >> level);
    }

    int exponent_;
    std::int64_t half_;
    std::vector<Bits> taken_;  // of each level: whether something in the cell is taken
    std::vector<Bits> near_;   // the same of one of the 3 by 3 cells around
};

inline int Occupancy::empty_exponent(std::int64_t x, std::int64_t y, int hint) const {
    const std::int64_t column = x + half_, row = y + half_;
    const int last = static_cast<int>(near_.size()) - 1;
    int level = hint < 0 ? 0 : hint > last ? last : hint;
    while (level > 0 && bit(near_[static_cast<std::size_t>(level)], index(level, column, row)))
        --level;
    while (level < last &&
           !bit(near_[static_cast<std::size_t>(level) + 1], index(level + 1, column, row)))
        ++level;
    return level;
}

/// Where a walk on the square grid leaves a square: one that starts in the middle of the cells with
/// |x| <= r and |y| <= r and steps to each of the four neighbours with chance 1/4 first comes to
/// the border of the square at (r, y), |y| < r, with this chance; by symmetry on all four sides.
/// That is
///
///     1/N sum over odd k of (-1)^((k-1)/2) sin(pi k (y + r) / N) / cosh(a_k N / 2),
///
/// N = 2r and cosh a_k = 2 - cos(pi k / N): the discrete Poisson kernel of a square, by separation
/// of variables (McCrea and Whipple, Random paths in two and three dimensions, 1940). Rounding
/// errors of doubles only. O(1).
///
/// Throws Error unless |y| < r.
///
/// Example: square_exit_chance(1, 0) < 0.2500001
double square_exit_chance(std::int64_t r, std::int64_t y);

/// Draws from the above for r = 1, 2, 4, ..., 2^most, in constant time (the alias method: Walker
/// 1977; Vose 1991).
class SquareExits {
public:
    static constexpr int most = 11;

    struct Step {
        std::int64_t x, y;
    };

    /// The tables, which are made once.
    static const SquareExits& tables();

    /// The step from the middle to the border of the square with r = 2^exponent, from two random
    /// numbers.
    Step at(int exponent, std::uint64_t first, std::uint64_t second) const;

private:
    SquareExits();

    struct Entry {
        std::uint64_t threshold;  // of 62 bits: below it the entry itself, otherwise the other one
        std::uint32_t other;
    };
    std::vector<std::vector<Entry>> tables_;
};

/// Where Brownian motion from `from`, outside of the circle of this radius around the origin, first
/// meets the circle, by a random number: with the Poisson kernel, whose angle from that of `from`
/// is twice the arc tangent of (d - r) / (d + r) tan(pi (u - 1/2)), d being the distance from the
/// origin (Kaufman, Vespignani, Mandelbrot and Woog, Physical Review E 52, 1995). It always comes
/// back.
///
/// Example: return_to_circle({3, 0}, 1, std::uint64_t{1} << 63).x > 0.999
Point return_to_circle(Point from, double radius, std::uint64_t number);

/// A cell of the square grid.
struct GridCell {
    std::int32_t x = 0, y = 0;
    bool operator==(const GridCell&) const = default;
};

/// Diffusion-limited aggregation on the square grid (Witten and Sander, Physical Review Letters 47,
/// 1981). A particle walks from cell to cell, to each of the four neighbours with chance 1/4, until
/// one of these neighbours belongs to the cluster; there it stays. The first cell is the seed,
/// (0,0).
///
/// With a region of r cells, particles begin on any free cell of the square |x|, |y| <= r around
/// the seed, the Moore neighbourhood of range r, all with the same chance; one that leaves the
/// square is lost and another begins. Without one, they come from far away: they begin on a circle
/// around the cluster, and where they go twice as far out, they come back to it where Brownian
/// motion does.
///
/// What random numbers a particle uses depends on the seed of the numbers and on how many particles
/// were before it.
class GridAggregate {
public:
    /// The region. Throws Error if it is 0 or beyond 16383 cells.
    static std::optional<std::int64_t> checked(std::optional<std::uint64_t> region);

    /// Throws Error if the region is 0 or beyond 16383 cells.
    GridAggregate(std::uint64_t seed, std::optional<std::uint64_t> region, const Budget& budget);

    /// Puts a cell into the cluster. Throws Error if it is there already or outside of the region.
    void add(GridCell cell);
    /// Lets one particle walk until it stays, with jumps: from the middle of an empty square to
    /// where a walk leaves it (`square_exit_chance`), so that the chances are those of single
    /// steps. About the logarithm of the cluster's width in jumps. Throws Error if no cell of the
    /// region is free.
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

/// Diffusion-limited aggregation without a grid: discs of diameter 1 in Brownian motion, one after
/// the other from far away, each staying where it first touches the cluster. The first one is the
/// seed, at the origin. Its dimension is about 1.71 (Tolman and Meakin, Physical Review A 40,
/// 1989).
///
/// A disc stays when it is closer than `touching` to another one, and is moved on to it.
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

/// The dimension that the radius of gyration of a growing cluster gives: the slope of the logarithm
/// of the number of particles against that of the radius, by least squares over the last
/// `doublings` doublings of the number. Nothing with fewer than 3 of them. O(links).
std::optional<double> gyration_dimension(const std::vector<Link>& links, std::size_t doublings);

}  // namespace algae
