#pragma once

#include <string>

#include "base/budget.hpp"
#include "cli/plates.hpp"
#include "render/picture.hpp"
#include "system/lsystem.hpp"

namespace algae::cli {

/// What `draw --explain` was asked for.
struct ExplainRequest {
    std::string generation;  // as on the command line, or empty
    PlateChoices choices;
    std::string output, format;  // empty output: a table on standard output
    PictureOptions picture;
    bool json = false;
};

/// Explains the turtle of a generation, step by step: in a picture, or as a table or JSON on standard
/// output. Throws Error if the word is too long for that, naming a generation that is not.
int explain(const LSystem& system, const ExplainRequest& request, const Budget& budget);

}  // namespace algae::cli
