#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "render/animation.hpp"

namespace algae::cli {

/// What `draw` takes for pictures that move.
struct MotionOptions {
    std::string frame_time, loop;

    void add_to(CLI::App& verb);
    /// `usual`: seconds a frame where the command line does not say. Throws Error.
    AnimationTiming timing(double usual) const;
    /// Throws Error if an option is set that only animations have.
    void check_unused() const;
};

}  // namespace algae::cli
