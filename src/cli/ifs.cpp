#include "cli/relatives.hpp"

namespace algae::cli {

void add_ifs(Verbs& verbs) {
    add_relative_verb(verbs, "ifs", "The attractor of an iterated function system",
                      "  algae ifs fern -o fern.png\n"
                      "  algae ifs copy-machine --iterations 0..5 -o copies.pdf",
                      {{"--points", "points", "N", "so many points of the chaos game"},
                       {"--iterations", "generation", "N[..M]",
                        "the images of the start set instead, after so many rounds"},
                       {"--seed", "seed", "S", "of the chaos game (default 1)"}},
                      run_relative);
}

}  // namespace algae::cli
