#include "environment/open_figure.hpp"

#include <utility>

#include "base/error.hpp"
#include "environment/open_development.hpp"
#include "system/classes.hpp"

namespace algae {

std::unique_ptr<Figure> open_figure(const LSystem& system, std::uint64_t n, const Budget& budget,
                                    const FigureChoices& choices,
                                    std::shared_ptr<Environment> external) {
    const Class kind = class_of(system);
    if (!kind.open) return figure(system, n, budget, choices);
    if (leaves_tables_open(system) && !choices.seed && choices.tables.empty())
        throw Error("it has " + std::to_string(system.tables.size()) +
                    " tables, and neither their sequence nor a seed is given");
    if (!choices.tables.empty() && choices.tables.size() < n)
        throw Error("expected a table for each of " + std::to_string(n) + " steps, found " +
                    std::to_string(choices.tables.size()));
    RewritingChoices rewriting;
    rewriting.seed = choices.seed.value_or(rewriting.seed);
    rewriting.evenly = choices.seed && !kind.stochastic;
    rewriting.random_tables = choices.random_tables;
    OpenDevelopment development(system, rewriting, std::move(external), budget);
    development.go_to(n, choices.tables, budget);
    return figure(system, development.rules().kinds, development.word(), n, rewriting.seed, budget);
}

}  // namespace algae
