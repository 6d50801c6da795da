#pragma once

#include <string>

#include "system/lsystem.hpp"

namespace algae {

/// A system whose words are derived module by module as sentences speak of it: "the parametric D0L system
/// with axiom A(1); A(x) : x < 3 -> A(x+1)", constants behind.
std::string rewriting_text(const LSystem& system);

}  // namespace algae
