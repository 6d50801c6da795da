#include "environment/open_modules.hpp"

#include <string>
#include <utility>

#include "base/error.hpp"
#include "environment/open_development.hpp"
#include "system/classes.hpp"

namespace algae {

DerivedModules open_modules(const LSystem& system, std::uint64_t n, const FigureChoices& choices,
                            std::shared_ptr<Environment> external, const Budget& budget) {
    const Class kind = class_of(system);
    if (!kind.open) return derived_modules(system, n, choices, budget);
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
    return {development.rules().kinds, development.word(), rewriting.seed};
}

}  // namespace algae
