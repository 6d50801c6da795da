#include "cli/relatives.hpp"

namespace algae::cli {

void add_particles(Verbs& verbs) {
    add_relative_verb(
        verbs, "particles", "A system of particles: frames, or an animation",
        "  algae particles fireworks -o fireworks.png\n"
        "  algae particles fireworks --seed 2 -o fireworks.gif",
        {{"--show", "show", "FRAME", "the frame of the picture; several as \"10 20 30\""},
         {"--frames", "frames", "LAST", "the last frame of the animation"},
         {"--seed", "seed", "S", "of the random numbers (default: what the file says, or 1)"}},
        run_relative);
}

}  // namespace algae::cli
