#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dimension/slope_estimate.hpp"

namespace algae {

/// A measure at several scales, and what its growth with the scale says of the dimension.
struct Scaling {
    std::vector<double> sizes;   // of openings, radii, cells; each half of the one before
    std::vector<double> values;  // of the measure, one for each size
    /// Between each size and the next finer one: the dimension that their two values give.
    std::vector<double> slopes;
    /// The scales that were used: those from `first` to `last`, both included.
    std::size_t first = 0, last = 0;
    /// Nothing if there are too few of them.
    std::optional<Estimate> estimate;
    /// Which scales and why, in one sentence; or why nothing can be said.
    std::string because;
};

/// Which scales may be used, and in words what bounds them.
struct ScaleRange {
    double finest = 0, coarsest = 0;
    std::string scales = "scales";  // what they are called: "openings"
    std::string finest_is = "4 segments";
    std::string finer_ones_see = "single segments";
    /// Whether slopes that rise over all scales used are taken to go on rising to a limit.
    bool follow_rises = false;

    static constexpr double parts_of_whole = 8, details = 4;
    static constexpr std::size_t fewest = 4, most = 7;
};

/// `whole` and its halves down to `detail`, where there is one; at most `most`.
///
/// Example: halved_sizes(1, 0.2, 20) == std::vector<double>{1, 0.5, 0.25}
std::vector<double> halved_sizes(double whole, double detail, std::size_t most);

/// Fits the dimension to `powers`: of each size the logarithm of a number that grows as the size to
/// the power of the dimension. Of the scales within the range the seven finest are used; with fewer
/// than four there is no estimate, and `because` says so. The interval is that of `estimate_from`,
/// `widening.down` and `widening.up` divided by the number of slopes. O(sizes).
///
/// Throws Error if there are not as many powers as sizes, or none.
void fit_scaling(Scaling& scaling, const std::vector<double>& powers, const ScaleRange& range,
                 Widening widening, double most);

}  // namespace algae
