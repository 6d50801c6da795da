#pragma once
// shape: boxes parallel to the axes, and the rules that divide them.

#include <array>
#include <string>
#include <vector>

#include "exact/rational.hpp"
#include "word/alphabet.hpp"

namespace algae {

/// A box parallel to the axes with a symbol. Places and sizes along X, Y and Z are exact, in the
/// units of the file; sizes are above 0.
struct ShapeBox {
    Symbol symbol = 0;
    std::array<Rational, 3> origin;  // its lowest corner
    std::array<Rational, 3> size;

    bool operator==(const ShapeBox&) const = default;
};

/// "X", "Y" or "Z" of 0, 1 or 2.
///
/// Example: axis_name(1) == 'Y'
char axis_name(std::size_t axis);

/// Symbol, origin and size with blanks between, `A 0 0 0 6 1/3 2.5`: decimals where they are
/// exact, fractions where not.
std::string box_text(const Alphabet& alphabet, const ShapeBox& box);

/// The symbols of boxes, in their order.
Word symbols_of(const std::vector<ShapeBox>& boxes);

}  // namespace algae
