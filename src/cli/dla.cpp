#include "cli/relatives.hpp"

namespace algae::cli {

void add_dla(Verbs& verbs) {
    add_relative_verb(
        verbs, "dla",
        "Diffusion-limited aggregation: particles that walk until they touch the cluster",
        "  algae dla --particles 20000 --seed 5 --off-lattice -o cluster.png\n"
        "  algae dla dla -o dla.pdf",
        {{"--particles", "particles", "N",
          "how many join the seed (default 10000); several as \"100 1000\""},
         {"--seed", "seed", "S", "of the walks (default 1)"},
         {"--off-lattice", "off-lattice", "",
          "discs in the plane instead of cells of a square grid"},
         {"--region", "region", "CELLS",
          "particles begin within so many cells of the seed, and are lost beyond (default: they "
          "come from far away)"},
         {"--move", "move", "jumps|steps",
          "in a region: by jumps, or cell by cell as the algorithm is written; the chances are the "
          "same"},
         {"--stop-at-border", "stop-at-border", "yes|no",
          "when the cluster reaches the border of the region (default yes)"}},
        run_relative);
}

}  // namespace algae::cli
