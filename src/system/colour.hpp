#pragma once

#include <string_view>
#include <vector>

#include "system/settings.hpp"

namespace algae {

/// The colour of a name or a hexadecimal code: `black`, `darkgreen`, `#080`, `#008000`. Names are
/// those of CSS, in any case.
///
/// Throws Error with the nearest name if there is no such colour.
///
/// Example: colour_named("#ff0000") == colour_named("red")
Colour colour_named(std::string_view text);

/// The names, in alphabetical order.
///
/// Example: colour_names().front() == "aqua"
std::vector<std::string_view> colour_names();

/// The pure colour of a hue in degrees: 0 red, 120 green, 240 blue, 360 red again.
///
/// Example: hue(120) == colour_named("lime")
Colour hue(double degrees);

}  // namespace algae
