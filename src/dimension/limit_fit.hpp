#pragma once

#include <optional>

#include "dimension/exact_dimension.hpp"
#include "dimension/fit.hpp"
#include "dimension/limit_counts.hpp"
#include "growth/rate.hpp"

namespace algae {

/// Fits the dimension of a recurrent set to the cells it touches.
///
/// Where pieces meet in finitely many ways, the number of cells at scale j is close to
/// A r^(j D) + B rho^j, r the ratio of scales and rho the rate at which pairs of parts that meet
/// multiply, which is known exactly (`meeting`, of one generation). The combination n_j - rho n_(j-1)
/// is free of the second term, and the estimate is the slope of its logarithm over the finest
/// scales: up to four of them, as many as make the interval shortest. Where rho is not known, or so
/// near the rate of the parts that the difference is lost (Levy's curve), the local slopes are
/// extrapolated as if their changes went on shrinking, and the interval is wide.
///
/// The interval: three standard errors over the places of the grid, leaving one out at a time, and
/// the change from the estimate one scale coarser; of extrapolated slopes, what was added to the last
/// one once more. Nothing is above `bound`: 2 for sets in the plane, or what the rules give.
BoxFit fit_limit(const LimitCounts& counts, const std::optional<Rate>& meeting, double bound = 2);

/// What is measured on the limit that the rules lead to.
struct LimitMeasure {
    LimitCounts counts;
    BoxFit fit;
};

/// Counts and fits with what is known exactly: `exact.limit` must be there. Where parts coincide, which
/// costs more for each cell, half as many cells are touched.
LimitMeasure measure_limit(const ExactDimension& exact, LimitCounting counting,
                           const Budget& budget = {});

}  // namespace algae
