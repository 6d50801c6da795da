#pragma once

#include <optional>
#include <string_view>

#include "notation/reading.hpp"

namespace algae {

/// The shape successor `div(Y, 3, 1r, 1r){ B C C }`, `div(XZ, 1r, 1r : 2, 1r){ B }`, `repeat(Y, 0.3){ C }`
/// or `I(B)`, or nothing if the text is none of them. `Split` is read as `div`. `I(B)` is one only if
/// the production has no parameters, or three, and B is neither one of them nor a constant;
/// otherwise it is a module with an argument. Throws `SyntaxError`.
std::optional<ShapeSuccessor> parse_shape(std::string_view text, const Production& production,
                                          Reading& reading);

}  // namespace algae
