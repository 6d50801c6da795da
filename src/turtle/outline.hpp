#pragma once

#include <complex>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "exact/cyclotomic.hpp"
#include "exact/rational.hpp"
#include "system/lsystem.hpp"
#include "turtle/derived_modules.hpp"

namespace algae {

/// What a figure leaves on the paper: different strokes between different points, whatever their
/// order, direction, number, colour and width, and the filled polygons.
struct Outline {
    using Stroke = std::pair<std::uint32_t, std::uint32_t>;  // numbers of points, the smaller first

    /// The same points as numbers of Z[zeta_m], seen from the start and measured in steps.
    struct Lattice {
        CyclotomicRing ring;
        std::vector<CyclotomicInteger> points;
        std::optional<Rational> unit;  // the length of a step, where it is rational
    };

    std::vector<std::complex<double>> points;
    std::vector<Stroke> strokes;                       // increasing
    std::vector<std::vector<std::uint32_t>> polygons;  // corners in increasing order; increasing
    std::optional<Lattice> lattice;                    // where all of it is exact
};

/// The outline of generation `n`. Exact for D0L systems whose angles are exact, that do not change
/// the length of a step within a figure and fill nothing. Throws what `figure` throws, BoundReached
/// if there are more than a million strokes. The length of the word times the degree of the ring.
Outline outline(const LSystem& system, std::uint64_t n, const Budget& budget = {},
                const FigureChoices& choices = {});

}  // namespace algae
