#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "notation/reading.hpp"

namespace algae {

/// The first words of all settings, in the order in which they are printed.
const std::vector<std::string>& setting_names();

/// The kinds of expectations, in `expect length 3: 148`.
const std::vector<std::string>& expectation_kinds();

/// The shape of a stamp as it is written, in `stamp S square`.
///
/// Example: shape_name(StampShape::circle) == std::string("circle")
const char* shape_name(StampShape shape);

/// Reads `let NAME = EXPRESSION` into the system. Throws `SyntaxError`.
void read_constant(const Clause& clause, Reading& reading);

/// Reads names longer than the notation knows, `alphabet wall window`. Throws `SyntaxError`.
void read_alphabet(const Clause& clause, Reading& reading);

/// Reads what fills the communication modules of one name, `environment ?E clip 0 0 4 3`. Throws
/// `SyntaxError`.
void read_environment(const Clause& clause, Reading& reading);

/// Throws `SyntaxError` if the symbol has a stamp, a solid or a surface already.
void check_unnamed(Symbol symbol, const char* place, const Reading& reading);

/// Whether a setting is one of those for figures in space.
///
/// Example: is_space_setting("camera") && !is_space_setting("angle")
bool is_space_setting(std::string_view name);

/// Reads a setting for figures in space: solid, surface, tropism, susceptibility, camera, light, fog.
/// Throws `SyntaxError`.
void read_space_setting(const Clause& clause, Reading& reading);

/// Reads any other setting whose value is no word. Throws `SyntaxError`.
void read_setting(const Clause& clause, Reading& reading);

}  // namespace algae
