#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/plates.hpp"
#include "render/animation.hpp"
#include "turtle/derived_modules.hpp"

namespace algae::cli {

/// What `draw` takes for pictures that move, and for explanations.
struct MotionOptions {
    std::string frame_time, loop, max_frames;
    bool progressive = false, explain = false;

    void add_to(CLI::App& verb);
    /// `usual`: seconds a frame where the command line does not say. Throws Error.
    AnimationTiming timing(double usual) const;
    /// Throws Error if an option is set that makes no sense: `moves` in a file that holds an animation.
    void check(bool moves) const;
    /// The same for what does not move.
    void check_unused() const { check(false); }
};

/// The word of a generation with the choices of the command line, or of the file. Throws what
/// open_modules throws.
DerivedModules word_to_walk(const LSystem& system, std::uint64_t n, const PlateChoices& choices,
                            const Budget& budget);

}  // namespace algae::cli
