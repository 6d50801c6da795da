#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "notation/findings.hpp"
#include "notation/source.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// The system that a part of a source says, in the notation of `.lsys` files, with findings at their places
/// in the source. `declared` are names of more than one character that are symbols there without having been
/// declared. The system is meaningless if findings were added.
LSystem read_system(std::string_view text, const Source& source, Findings& findings,
                    const std::string& name, const std::vector<std::string>& declared);

}  // namespace algae
