#pragma once

#include <algorithm>
#include <complex>
#include <cstdint>

#include "turtle/compass.hpp"

namespace algae {

/// What a part of a derivation does to a turtle and where it draws, in doubles: enough to leave a
/// part out, or to draw a stroke instead of it, when it is too small to be seen. A part's drawing
/// is kept as a disc around it. The laws of a monoid hold up to rounding.
class Pieces {
public:
    struct value_type {
        std::complex<double> move;           // from its start to its end, turtle looking along +x
        Compass::Heading turn = 0;
        double size = 1;                     // factor on the turtle's own step
        double width = 1;                    // factor on the line width
        double colours = 0;                  // steps in the list of colours
        std::complex<double> centre;         // of a disc around all that is drawn
        double radius = -1;                  // negative: nothing is drawn
        double letters = 0;
        bool operator==(const value_type&) const = default;

        bool draws() const { return radius >= 0; }
        /// How far from the start the drawing reaches at most.
        double reach() const { return draws() ? std::abs(centre) + radius : 0; }
        /// How far any point of the straight way from start to end is from any point drawn, at most.
        double extent() const {
            return draws() ? std::max(std::abs(centre), std::abs(move - centre)) + radius : 0;
        }
    };

    explicit Pieces(const Compass& compass) : compass_(&compass) {}

    value_type one() const { return {}; }
    void append(value_type& left, const value_type& right) const;
    value_type branch(const value_type& twig) const;

private:
    const Compass* compass_;
};

}  // namespace algae
