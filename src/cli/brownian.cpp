#include "cli/relatives.hpp"

namespace algae::cli {

void add_brownian(Verbs& verbs) {
    add_relative_verb(
        verbs, "brownian", "Fractional Brownian motion, exactly or by displacing midpoints",
        "  algae brownian --hurst 0.7 --levels 12 -o path.svg\n"
        "  algae brownian --method midpoint --levels 1..6 -o displacements.pdf",
        {{"--hurst", "hurst", "H",
          "how smooth it is, between 0 and 1 (default 0.5); several as \"0.2 0.8\""},
         {"--sigma", "sigma", "NUMBER", "the root of the variance of X(1) (default 1)"},
         {"--levels", "levels", "N[..M]", "2^N steps (default 10); a figure for each of a range"},
         {"--dimensions", "dimensions", "1|2|3",
          "independent coordinates (default 1, the graph against time)"},
         {"--method", "method", "exact|midpoint",
          "by circulant embedding (default) or midpoint displacement"},
         {"--seed", "seed", "S", "of the random numbers (default 1)"}},
        run_relative);
}

}  // namespace algae::cli
