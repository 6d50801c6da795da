#pragma once

#include <vector>

#include "exact/integer.hpp"
#include "exact/rational.hpp"

namespace algae {

/// A size as a rule gives it: a length, or a share of what the lengths leave.
struct Share {
    Rational value;
    bool relative = false;
};

/// The lengths into which an extent is cut: absolute ones as they are, a relative one r as
/// r * (extent - sum of the absolute ones) / sum of the relative ones (div with relative sizes).
/// Without relative sizes the lengths may leave a rest, which stays empty. Throws Error if a size
/// is not above 0, if the lengths add up to more than the extent, or if they leave nothing for
/// relative ones.
///
/// Example: lengths_of(10, {{2}, {1, true}, {1, true}, {2}})[1] == 3
std::vector<Rational> lengths_of(const Rational& extent, const std::vector<Share>& sizes);

/// How many parts of a size fit into an extent: the greatest whole number not above extent / size
/// (repeat). The parts fill the extent, so each of them is extent / that number long: the size
/// itself where the quotient is whole. Throws Error if the size is not above 0 or above the extent.
///
/// Example: parts_that_fit(10, 3) == 3
Integer parts_that_fit(const Rational& extent, const Rational& size);

}  // namespace algae
