#pragma once

#include <string_view>

#include "lesson/exercise.hpp"
#include "notation/findings.hpp"
#include "notation/source.hpp"

namespace algae {

/// Puts what the lines of a text say into an exercise, but for what its name says. `source` is the text with its places;
/// what is wrong with lines becomes findings. Linear but for what suggestions take.
void read_exercise_lines(std::string_view text, Exercise& exercise, const Source& source,
                         Findings& findings);

}  // namespace algae
