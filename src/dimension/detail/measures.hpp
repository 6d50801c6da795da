#pragma once

// What the measures share: samples of a figure, radii, fits over scales; and their parts that tests
// look at.

#include <cmath>

#include "dimension/dimension.hpp"

namespace algae {

/// Whether there are at least four slopes and each is greater than the one before.
///
/// Example: still_rise({1.1, 1.2, 1.25, 1.27})
bool still_rise(const std::vector<double>& slopes);

/// Between each scale and the next finer one: how fast the mean count grows with 1 / cell.
///
/// Example: local_slopes({{1, 2, 2}, {{1}, {4}}}) == std::vector<double>{2}
std::vector<double> local_slopes(const BoxCounts& counts);

/// How an interval is widened beyond the slopes: by these shares of their range, and upward by
/// `beyond` once more.
struct Widening {
    double down = 0, up = 0, beyond = 0;

    /// Counts of a finite generation are too low rather than too high: by this share of the range
    /// of the slopes, divided by their number, and by this share of a detail over the finest scale.
    static constexpr double upward = 4.5, missed = 0.05;
};

/// What local slopes, from the coarsest scale to the finest, say of the slope of the limit. The
/// value is `slope`, that over all scales, or what the slopes tend to where they still rise and
/// the rises go on shrinking as they do. The interval holds all slopes and what their trend adds
/// once more, and is widened. At least one slope is needed. Nothing is below 0 or above `most`.
Estimate estimate_from(const std::vector<double>& slopes, double slope, const Widening& widening,
                       double most);

/// Which scales may be used, and in words what bounds them.
struct ScaleRange {
    double finest = 0, coarsest = 0;
    std::string scales = "scales";  // what they are called: "openings"
    std::string finest_is = "4 segments";
    std::string finer_ones_see = "single segments";
    /// Whether slopes that rise over all scales used are taken to go on rising to a limit.
    bool follow_rises = false;

    /// The coarsest scale used is this share of the whole; the finest holds so many details in a
    /// row, or so many points on average.
    static constexpr double parts_of_whole = 8, details = 4, points_in_cell = 8;
    static constexpr std::size_t fewest = 4, most = 7;  // scales
    /// Cells of points hold so many standard deviations of their noise.
    static constexpr double noises = 12;
};

/// The logarithm, up to a constant, of the share of pairs at most `radius` apart among points that are spread evenly along a set of
/// the dimension D in space of d dimensions and are then each moved by normal noise with the standard deviation `noise` in every
/// coordinate: r^d 1F1((d - D) / 2; d / 2 + 1; -r^2 / (4 noise^2)). It grows as r^D far above the noise, as r^d below.
///
/// Example: noisy_correlation(1.5, 2, 1, 200) - noisy_correlation(1.5, 2, 1, 100) > 1.49 * std::log(2)
double noisy_correlation(double dimension, int space, double noise, double radius);

/// `whole` and its halves down to `detail`, where there is one; at most `most`.
///
/// Example: halved_sizes(1, 0.2, 20) == std::vector<double>{1, 0.5, 0.25}
std::vector<double> halved_sizes(double whole, double detail, std::size_t most = 20);

/// Fits the dimension to `powers`: of each size the logarithm of a number that grows as the size to
/// the power of the dimension. Of the scales within the range the seven finest are used; with fewer
/// than four there is no estimate, and `because` says so. The interval is that of `estimate_from`,
/// `widening.down` and `widening.up` divided by the number of slopes. O(sizes).
///
/// Throws Error if there are not as many powers as sizes, or none.
void fit_scaling(Scaling& scaling, const std::vector<double>& powers, const ScaleRange& range,
                 Widening widening, double most);

/// How places are chosen along a length: one in each of equal stretches, which is the more even; or
/// each by itself, so that how far two of them are apart does not depend on how many there are.
enum class Spread { stretches, independent };

/// So many random points of what a figure draws, every place of its length as likely as any other,
/// in drawing order. What is drawn twice counts twice. The same for the same seed on every machine.
/// The figure is drawn twice; 32 bytes a point. `detail` is the figure's step.
///
/// Throws Error if nothing is drawn that has a length, BoundReached, Interrupted.
PointSet even_sample(const Figure& figure, std::size_t count, Spread spread, std::uint64_t seed,
                     const Budget& budget);

/// So many of the points at random, in their order; all of them if there are no more (selection
/// sampling: Knuth, The Art of Computer Programming 2, algorithm 3.4.2 S).
PointSet even_sample(const PointSet& points, std::size_t count, std::uint64_t seed);

/// How far two points are from each other.
///
/// Example: distance({0, 0, 1}, {3, 4, 1}) == 5
double distance(const std::array<double, 3>& a, const std::array<double, 3>& b);

/// The cell of each point, in its order, in one grid of cells that are intervals, squares or cubes,
/// the longest side divided by 2^(count - 1) wide; the grid is moved by shares of the longest side.
/// Bits of the coordinates in turns: `code >> columns` is the cell twice as wide. At most 20
/// scales.
///
/// Throws Error if all points are the same or there are too many scales, Interrupted.
std::vector<std::uint64_t> cell_codes(const PointSet& points, std::size_t count,
                                      const std::array<double, 3>& shares, const Budget& budget);

/// The first `count` places of grids for points, in shares: those of `even_offsets` and a third
/// one.
std::vector<std::array<double, 3>> even_places(std::size_t count);

/// How many of `count` radii, the first one `greatest` and each half of the one before, are at
/// least `distance`. The same as comparing with each, and quicker.
///
/// Example: halved_radii(8, 2, 20) == 3
inline std::size_t halved_radii(double greatest, double distance, std::size_t count) {
    if (!(distance <= greatest)) return 0;
    if (!(distance > 0)) return count;
    int at_most = 0, bound = 0;
    const double whole = std::frexp(greatest, &at_most), part = std::frexp(distance, &bound);
    const auto halvings = static_cast<std::size_t>(at_most - bound - (part > whole ? 1 : 0));
    return halvings < count ? halvings + 1 : count;
}

/// The length of the segment that lies within a disc.
///
/// Example: length_within({-2, 0}, {2, 0}, {0, 0}, 1) == 2
double length_within(Point from, Point to, Point centre, double radius);

/// Of how many pairs of the points the distance is at most each of these radii, the first one
/// `greatest` and each half of the one before. Points are compared with those in the cells around
/// theirs, cells as wide as `greatest`. O(points log points + pairs in those cells).
///
/// Throws Error unless `greatest` is above 0, BoundReached, Interrupted.
std::vector<std::uint64_t> near_pairs(const PointSet& points, double greatest, std::size_t radii,
                                      const Budget& budget);

/// The connected strokes of a figure; outlines of polygons are closed. 16 bytes a segment: throws
/// BoundReached if that is more than budget.memory, Error if nothing is drawn.
std::vector<Stroke> strokes_of(const Figure& figure, const Budget& budget);

/// How many steps dividers of this opening take along a stroke from its first point to its last.
/// Each step goes to the first point of the stroke, on its segments too, that is one opening away:
/// where the circle meets the segment. What remains at the end counts as a share of a step. 0 for
/// fewer than two points. O(points + steps).
///
/// Throws Error unless the opening is above 0, Interrupted.
///
/// Example: divider_steps(Stroke{{0, 0}, {3, 0}, {3, 1}}, 2, Budget()) == 1 + std::sqrt(2) / 2
double divider_steps(std::span<const Point> stroke, double opening, const Budget& budget);

/// The lacunarity (Allain and Cloitre, Phys. Rev. A 44, 1991) for boxes of these sides, in cells: a
/// box glides over all places within the rectangle, from cell to cell, and with M how many filled
/// cells it holds, lacunarity is the mean of M^2 over the square of the mean of M. It is 1 for what
/// looks the same everywhere, and greater the more the gaps differ. In one row a box is a stretch.
/// O(cells) time for each side, 8 bytes a cell.
///
/// Throws Error if no cell is filled or a side is 0 or longer than a side of the rectangle,
/// BoundReached, Interrupted.
///
/// Example: lacunarities({2, 2, {true, false, false, true}, 1}, std::vector{1ul}, Budget())[0] == 2
std::vector<double> lacunarities(const CellRectangle& cells, std::span<const std::size_t> sides,
                                 const Budget& budget);

/// Counts the cells that the set touches, by going down from the whole to ever smaller parts. A
/// part smaller than 1/128 of a cell counts for the cell of one of its points, also where it lies
/// on a border.
///
/// Scales go from about 8 cells across (2 where the ratio is large) to where about `most_cells` are
/// touched, but there are at least 4 scales, and at most 2^40 cells lie across. Uses all
/// processors; the numbers do not depend on how many there are. Throws BoundReached, Interrupted.
LimitCounts limit_counts(const RecurrentSet& set, const LimitCounting& options = {},
                         const Budget& budget = {});

/// What no set in the plane for which the rules give this upper bound exceeds; 2 for other ones.
double greatest_dimension(const ExactDimension& exact);

/// What is known exactly of how counts of cells grow from generation to generation: as a sum of
/// powers of the rate of the whole and of these, which the fit takes out.
struct LowerTerms {
    std::vector<Rate> rates;      // of components that multiply more slowly than the largest
    std::optional<Rate> largest;  // of the whole
    std::size_t chain = 1;        // so many components with it follow on each other: n^(chain - 1)
};

/// Of a set whose value counts all parts; nothing where parts coincide.
LowerTerms lower_terms(const ExactDimension& exact);

/// Fits the dimension of a recurrent set to the cells it touches. `meeting` is the rate at which
/// pairs of parts that meet multiply from generation to generation, where it is known. Nothing is
/// above `bound`: 2 for sets in the plane, or what the rules give.
BoxFit fit_limit(const LimitCounts& counts, const std::optional<Rate>& meeting, double bound = 2,
                 const LowerTerms& lower = {});

}  // namespace algae
