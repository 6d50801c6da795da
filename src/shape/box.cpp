#include "shape/box.hpp"

#include "system/expression.hpp"

namespace algae {

char axis_name(std::size_t axis) { return "XYZ"[axis]; }

std::string box_text(const Alphabet& alphabet, const ShapeBox& box) {
    std::string text = alphabet.name(box.symbol);
    for (const Rational& place : box.origin) text += ' ' + shortest_text(place);
    for (const Rational& size : box.size) text += ' ' + shortest_text(size);
    return text;
}

Word symbols_of(const std::vector<ShapeBox>& boxes) {
    Word symbols;
    symbols.reserve(boxes.size());
    for (const ShapeBox& box : boxes) symbols.push_back(box.symbol);
    return symbols;
}

}  // namespace algae
