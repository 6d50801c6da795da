#include "notation/walk_file.hpp"

#include "nature/random_walks.hpp"
#include "notation/relative_values.hpp"

namespace algae {

namespace {

constexpr std::uint64_t most_steps = 1'000'000'000;

std::unique_ptr<Relative> make(const RelativeFile& file) {
    auto walks = std::make_unique<RandomWalks>();
    file.describe(*walks);
    walks->steps = natural_values(file, "steps", 1, most_steps).value_or(walks->steps);
    walks->walk.dimensions = static_cast<int>(file.natural("dimensions", 1, 3).value_or(2));
    walks->walk.deviation = positive_value(file, "deviation").value_or(1);
    walks->walk.seed = seed_value(file);
    walks->check();
    return walks;
}

}  // namespace

RelativeKind walk_kind() {
    return {"walk",
            "a random walk",
            {{"steps", "N ..."}, {"dimensions", "1|2|3"}, {"deviation", "NUMBER"}, {"seed", "S"}},
            make};
}

}  // namespace algae
