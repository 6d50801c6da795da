#include "notation/dla_file.hpp"

#include "nature/aggregates.hpp"
#include "notation/relative_values.hpp"

namespace algae {

namespace {

std::unique_ptr<Relative> make(const RelativeFile& file) {
    auto cluster = std::make_unique<Aggregates>();
    file.describe(*cluster);
    cluster->particles =
        natural_values(file, "particles", 1, Aggregates::most).value_or(cluster->particles);
    cluster->seed = seed_value(file);
    cluster->off_lattice = file.choice("off-lattice", {"yes", "no"}).value_or("no") == "yes";
    cluster->region = file.natural("region", 1, 16383);
    cluster->by_steps = file.choice("move", {"jumps", "steps"}).value_or("jumps") == "steps";
    cluster->stop_at_border = file.choice("stop-at-border", {"yes", "no"}).value_or("yes") == "yes";
    if (cluster->off_lattice && cluster->region)
        file.fail(*file.find("region"), "clusters off the lattice have no region");
    if (cluster->by_steps && !cluster->region)
        file.fail(*file.find("move"), "expected a region, which single steps need");
    cluster->check();
    return cluster;
}

}  // namespace

RelativeKind dla_kind() {
    return {"dla",
            "a cluster of diffusion-limited aggregation",
            {{"particles", "N ..."},
             {"seed", "S"},
             {"off-lattice", "yes|no"},
             {"region", "CELLS"},
             {"move", "jumps|steps"},
             {"stop-at-border", "yes|no"}},
            make};
}

}  // namespace algae
