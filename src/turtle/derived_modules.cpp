#include "turtle/derived_modules.hpp"

#include <string>
#include <utility>

#include "base/error.hpp"
#include "rewrite/rewriting.hpp"
#include "system/classes.hpp"
#include "system/d0l.hpp"
#include "system/ol.hpp"

namespace algae {

void check_choices(const LSystem& system, std::uint64_t n, const FigureChoices& choices) {
    const auto refuse = [&](const std::string& reason) {
        throw Error("cannot draw " + (system.name.empty() ? "the system" : system.name) + ": " +
                    reason);
    };
    const Class kind = class_of(system);
    if (kind.shape) refuse("it has shape rules, which make boxes and not words for a turtle");
    if (kind.open) refuse("it has communication modules, and there is no environment to fill them");
    if (!choices.tables.empty() && choices.tables.size() < n)
        throw Error("expected a table for each of " + std::to_string(n) + " steps, found " +
                    std::to_string(choices.tables.size()));
    if (choices.seed || !choices.tables.empty()) return;
    if (leaves_tables_open(system))
        refuse("it has " + std::to_string(system.tables.size()) +
               " tables, and neither their sequence nor a seed is given");
    if (as_ol(system) && !as_d0l(system)) refuse(as_d0l(system).reason());
}

DerivedModules derived_modules(const LSystem& system, std::uint64_t n, const FigureChoices& choices,
                               const Budget& budget) {
    check_choices(system, n, choices);
    constexpr std::uint64_t usual_seed = 1;
    RewritingChoices rewriting_choices;
    rewriting_choices.seed = choices.seed.value_or(usual_seed);
    rewriting_choices.evenly = choices.seed && !class_of(system).stochastic;
    rewriting_choices.random_tables = choices.random_tables;
    const Rewriting rewriting(system, rewriting_choices, budget);
    ModuleString word = derive(rewriting, n, choices.tables, budget);
    return {rewriting.rules().kinds, std::move(word), rewriting_choices.seed};
}

}  // namespace algae
