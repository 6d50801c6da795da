#pragma once

#include <cstdint>
#include <vector>

#include "dimension/divider.hpp"
#include "nature/relative.hpp"

namespace algae {

/// A set covered with squares of several sizes, as box counting does: the squares of a grid that the
/// set touches, and their number.
class BoxCover : public Relative {
public:
    enum class Shape { segment, square, koch, coast };

    Shape shape = Shape::koch;
    std::vector<double> cells{1, 0.5, 0.25};  // the sides of the squares
    bool turned = false;  // of Koch's curve: three squares to each copy, turned with it
    bool plot = false;    // then one figure: log N(m) against log(1/m), and the line that fits best
    std::uint64_t seed = 1;  // of the coast

    /// Throws Error on sides of 0, above 1 or below 1/4096.
    void check() const;
    /// The set as lines; the square as its outline. Its longest side is 1, its lower left corner (0, 0).
    std::vector<Stroke> strokes(const Budget& budget) const;
    /// A square by its lower left corner and the way to the next one.
    struct Square {
        Point corner, edge;
    };
    /// The squares of this side that the set touches, each once. A point on the upper or right end of
    /// the whole belongs to the square before it. Turned, 3 * 4^(n-1) of the side 3^-n, as a copy is
    /// lower than a third of its width; Error for other sides.
    std::vector<Square> covering(double side, const Budget& budget) const;

    std::vector<RelativeFigure> figures(const Budget& budget) const override;
    RelativeFigure measured_figure(const Budget& budget) const override;
    std::vector<RelativeFact> facts(const Budget& budget) const override;
};

}  // namespace algae
