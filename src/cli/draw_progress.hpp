#pragma once

#include <string>

#include "base/budget.hpp"
#include "cli/draw_motion.hpp"
#include "cli/plates.hpp"
#include "render/picture.hpp"
#include "system/lsystem.hpp"

namespace algae::cli {

/// What `draw --progressive` was asked for.
struct ProgressRequest {
    std::string generation;  // as on the command line, or empty
    PlateChoices choices;
    std::string output, format;
    PictureOptions picture;
    MotionOptions motion;
    bool captions = false;
    std::string caption;
    bool json = false;
};

/// Draws the turtle at work: a symbol a frame of an animation, or a page. Where that makes too many
/// frames several symbols go into one, which a note says. Throws Error for a format that has neither
/// frames nor pages.
int draw_progress(const LSystem& system, const ProgressRequest& request, const Budget& budget);

}  // namespace algae::cli
