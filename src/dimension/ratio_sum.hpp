#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dimension/way_growth.hpp"
#include "exact/ball.hpp"
#include "system/expression.hpp"

namespace algae {

/// The similarity dimension of a graph-directed set with unequal ratios (Mauldin and Williams,
/// Hausdorff dimension in graph directed constructions, 1988): the s for which the matrix of the sums
/// of (|ratio| / m)^s over the parts from each state to each state has the spectral radius 1. For a
/// single state, sum (|ratio| / m)^s = 1 (Moran 1946).
class RatioSum {
public:
    struct Entry {
        std::size_t from, to;
        Expression ratio;
    };

    /// The states must all lead to each other, and have more parts than one. Throws Error where
    /// the parts do not become smaller: no s is large enough.
    RatioSum(std::size_t states, std::vector<Entry> entries, WayGrowth growth);
    /// The same with m = 1: the ratios are those of the parts to the whole.
    RatioSum(std::size_t states, std::vector<Entry> entries);

    /// With a radius of at most 2^-bits. By bisection: the spectral radius falls as s grows, and is
    /// below 1 exactly if elimination in the unit matrix less this one finds positive pivots only.
    Ball enclosure(long bits) const;
    /// "0.3^s + 2*(0.21^0.5)^s + 0.7^s = m^s with m = 1.06393", where it can be written so: with a
    /// state on all cycles and not too many ways back to it.
    std::string text() const;
    /// Correctly rounded to so many digits after the point.
    std::string decimal(int digits) const;

private:
    std::size_t states_;
    std::vector<Entry> entries_;
    std::optional<WayGrowth> growth_;  // none: m = 1

    void check() const;
    Ball growth(long bits) const;
};

}  // namespace algae
