#include "notation/brownian_file.hpp"

#include "nature/brownian_paths.hpp"
#include "notation/relative_values.hpp"

namespace algae {

namespace {

std::unique_ptr<Relative> make(const RelativeFile& file) {
    auto paths = std::make_unique<BrownianPaths>();
    file.describe(*paths);
    paths->hurst = hurst_values(file, "hurst").value_or(paths->hurst);
    paths->sigma = positive_value(file, "sigma").value_or(1);
    paths->levels =
        level_values(file, "levels", BrownianMotion::most_levels).value_or(paths->levels);
    paths->dimensions = static_cast<int>(file.natural("dimensions", 1, 3).value_or(1));
    paths->exact = file.choice("method", {"exact", "midpoint"}).value_or("exact") == "exact";
    paths->seed = seed_value(file);
    paths->check();
    return paths;
}

}  // namespace

RelativeKind brownian_kind() {
    return {"brownian",
            "fractional Brownian motion",
            {{"hurst", "H ..."},
             {"sigma", "NUMBER"},
             {"levels", "N or N..M"},
             {"dimensions", "1|2|3"},
             {"method", "exact|midpoint"},
             {"seed", "S"}},
            make};
}

}  // namespace algae
