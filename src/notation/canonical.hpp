#pragma once

#include <string>
#include <vector>

#include "system/lsystem.hpp"

namespace algae {

/// One line of the canonical text.
struct CanonicalLine {
    std::string keyword;  // the setting's; "->" of a rule
    std::string text;     // the whole line, without its break
    std::vector<CanonicalLine> inside = {};  // of `system leaf {`: the lines up to its brace
};

/// The canonical text of a system, line by line.
std::vector<CanonicalLine> canonical_lines(const LSystem& system);

/// What fills a module, as it stands behind `environment`: `?E clip 0 0 4 3`.
std::string print_environment(const Alphabet& alphabet, const EnvironmentSetting& environment);

/// What stands behind the symbol of a solid or of a surface: `box width height`, `leaf`.
std::string print_solid(const SolidSetting& solid);
std::string print_surface(const SurfaceSetting& surface);

}  // namespace algae
