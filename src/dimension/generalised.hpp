#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/budget.hpp"
#include "dimension/points.hpp"
#include "dimension/scaling.hpp"
#include "turtle/figure.hpp"

namespace algae {

/// The generalised dimension of one order.
struct GeneralisedDimension {
    double order = 0;
    /// The values are the sums of p^order over the boxes, for order 1 the information -sum p log p.
    Scaling scaling;
};

/// The dimensions D_q of Renyi (Hentschel and Procaccia, Physica D 8, 1983) of the length that a
/// figure draws: with p the share of it in a box of side e, sum p^q grows as e^((q - 1) D_q), and
/// sum p log p as D_1 log e, the information dimension. D_0 is the box dimension, with the same
/// counts and the same estimate; what is drawn twice counts twice in all others.
///
/// For q below 0 a box that the set barely touches, whose p is as small as chance will have it,
/// would outweigh all others. So there p is the share in the box and those around it, a box three
/// times as wide that is never barely touched (Riedi, J. Math. Anal. Appl. 189, 1995): for q above
/// 0 the dimensions are the same, for q below 0 only these are those of the theory.
///
/// Along the edge of a set that fills the plane even those are partly empty: for orders below 0 the
/// value comes out low there, and the interval is wide.
///
/// Boxes are as wide as the whole and its halves down to four segments, in so many grids, one pass each;
/// sums are means over the grids. O((segments + boxes * orders) * offsets).
///
/// Throws Error if nothing is drawn or no order or no offset is given, BoundReached, Interrupted.
std::vector<GeneralisedDimension> generalised_dimensions(const Figure& figure,
                                                         std::span<const double> orders,
                                                         std::size_t offsets, const Budget& budget);

/// The same of points, each with its weight; all have the same if there are no weights. Used are
/// boxes with eight different points on average.
///
/// Throws Error also if there is not one weight, 0 or more, for each point, or all are 0.
std::vector<GeneralisedDimension> generalised_dimensions(const PointSet& points,
                                                         std::span<const double> weights,
                                                         std::span<const double> orders,
                                                         std::size_t offsets, const Budget& budget);

}  // namespace algae
