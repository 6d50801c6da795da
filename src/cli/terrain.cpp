#include "cli/relatives.hpp"

namespace algae::cli {

void add_terrain(Verbs& verbs) {
    add_relative_verb(
        verbs, "terrain",
        "A landscape: a random surface with water, as a map, contour lines, solid or its coast",
        "  algae terrain --levels 8 --roughness 0.8 --seed 4 --view solid -o land.png\n"
        "  algae terrain mountains -o mountains.glb",
        {{"--levels", "levels", "N[..M]", "2^N squares along an edge (default 8)"},
         {"--roughness", "roughness", "H", "between 0, rough, and 1, smooth (default 0.8)"},
         {"--relief", "height", "NUMBER",
          "the deviation of heights, in edges of the land (default 0.3)"},
         {"--water", "water", "SHARE", "of the land that lies below it (default 0.4)"},
         {"--view", "view", "map|contours|solid|coast|grid",
          "what is shown (default map); several as \"map solid\""},
         {"--lines", "lines", "N", "contour lines (default 12)"},
         {"--method", "method", "midpoint|exact",
          "displacing midpoints of squares (default), or exactly fractional Brownian"},
         {"--camera", "camera", "\"AZIMUTH ELEVATION\"",
          "where the solid view is seen from (default -60 35)"},
         {"--seed", "seed", "S", "of the random numbers (default 1)"}},
        run_relative);
}

}  // namespace algae::cli
