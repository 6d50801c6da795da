#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "nature/affine_map.hpp"
#include "nature/relative.hpp"
#include "system/expression.hpp"

namespace algae {

/// An iterated function system: finitely many maps of the plane that bring points together. There is
/// exactly one set, not empty and compact, that is the union of its images under them, the attractor
/// (Hutchinson 1981; Barnsley, Fractals Everywhere, 1988).
///
/// With several states it is graph-directed (Mauldin and Williams 1988): a set K_i for each state, the
/// union of the images of the sets K_to under the maps of the state i. The attractor is that of the
/// first state.
class IteratedFunctions : public Relative {
public:
    struct Map {
        std::array<Quantity, 6> numbers;  // a b c d e f, as exact as they are written
        AffineMap map;
        std::size_t from = 0, to = 0;  // states
        std::optional<Quantity> probability;
        std::optional<Expression> ratio;  // where it is a similarity: of distances, exactly
        std::string name;                 // "map 2", as messages call it
        /// How it was written, if as ratio and degrees.
        std::optional<std::pair<Quantity, Quantity>> similarity;
    };

    std::vector<std::string> states{""};
    std::vector<Map> maps;  // in the order of the file; its number is the index of its colour

    /// What its figures show: this many points of the chaos game; or the images of a polygon under
    /// the maps, in these generations; or the attractor.
    std::optional<std::uint64_t> points;
    std::optional<std::pair<std::uint64_t, std::uint64_t>> generations;
    std::uint64_t seed = 1;
    std::optional<Point> from;  // where the chaos game begins; the fixed point of the first map
    std::vector<Point> start{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

    /// Throws Error if there are no maps, a map that can come back does not bring points together
    /// (named with its norm), a state has no map, or probabilities are not positive or do not add up
    /// to 1 (with their sum). Call once after the maps are there.
    void check() const;

    /// The largest norm of a map that can come back; of others nothing is asked.
    double contraction() const;
    /// For each state, whether there are maps from it that lead back to it.
    std::vector<bool> recurrent_states() const;
    /// The chances of the maps in the chaos game: those said, or in proportion to the areas they
    /// leave, at least a hundredth of the largest.
    std::vector<double> chances() const;

    std::vector<RelativeFigure> figures(const Budget& budget) const override;
    /// The attractor, unless points or generations are asked for.
    RelativeFigure measured_figure(const Budget& budget) const override;
    std::optional<ExactDimension> exact_dimension(const Budget& budget) const override;
    /// The maps with norms, fixed points and probabilities, the contraction, the box of the
    /// attractor, the similarity dimension.
    std::vector<RelativeFact> facts(const Budget& budget) const override;
};

}  // namespace algae
