#include "cli/relatives.hpp"

namespace algae::cli {

void add_walk(Verbs& verbs) {
    add_relative_verb(
        verbs, "walk", "A random walk with Gaussian steps",
        "  algae walk --steps 10000 --seed 3 -o walk.svg\n"
        "  algae walk random-walk -o walk.pdf",
        {{"--steps", "steps", "N",
          "how many steps (default 10000); several as \"100 10000\" are side by side"},
         {"--dimensions", "dimensions", "1|2|3",
          "of the place (default 2); in one dimension the graph against time"},
         {"--deviation", "deviation", "NUMBER", "of each coordinate of a step (default 1)"},
         {"--seed", "seed", "S", "of the steps (default 1)"}},
        run_relative);
}

}  // namespace algae::cli
