#include "turtle/figure.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "fold/interaction.hpp"
#include "rewrite/rewriting.hpp"
#include "system/classes.hpp"
#include "system/ol.hpp"
#include "turtle/module_figure.hpp"
#include "turtle/plane_figure.hpp"

namespace algae {

namespace {

constexpr std::uint64_t usual_seed = 1;

std::string called(const LSystem& system) {
    return system.name.empty() ? "the system" : system.name;
}

/// Whether commands without parameters say all that a turtle is to do with words of letters.
bool is_plain(const LSystem& system) {
    if (!system.settings.stamps.empty()) return false;
    return std::all_of(
        system.interpretation.begin(), system.interpretation.end(), [](const Production& rule) {
            return !rule.condition && !rule.probability && rule.predecessor.parameters.empty() &&
                   rule.successor.arguments.empty() && rule.successor.splices.empty();
        });
}

/// Throws Error if derivation would have to guess.
void check_choices(const LSystem& system, const Class& kind, const FigureChoices& choices) {
    const auto refuse = [&](const std::string& reason) {
        throw Error("cannot draw " + called(system) + ": " + reason);
    };
    if (kind.shape) refuse("it has shape rules, which make boxes and not words for a turtle");
    if (kind.open) refuse("it has communication modules, and there is no environment to fill them");
    if (choices.seed || !choices.tables.empty()) return;
    if (leaves_tables_open(system))
        refuse("it has " + std::to_string(system.tables.size()) +
               " tables, and neither their sequence nor a seed is given");
    if (as_ol(system)) refuse(as_d0l(system).reason());
}

}  // namespace

std::unique_ptr<Figure> figure(const LSystem& system, std::uint64_t n, const Budget& budget,
                               const FigureChoices& choices) {
    const bool plain = is_plain(system);
    if (const View<D0L> rules = as_d0l(system); rules && plain)
        return std::make_unique<PlaneFigure>(system, *rules, n, n, budget);
    const Class kind = class_of(system);
    if (!as_d0l(system)) check_choices(system, kind, choices);
    if (!choices.tables.empty() && choices.tables.size() < n)
        throw Error("expected a table for each of " + std::to_string(n) + " steps, found " +
                    std::to_string(choices.tables.size()));
    const bool picked = choices.seed || !choices.tables.empty();
    if (const View<IL> rules = as_il(system); rules && plain && !picked)
        return figure(system, derive(*rules, n, budget), n, budget);
    RewritingChoices rewriting_choices;
    rewriting_choices.seed = choices.seed.value_or(usual_seed);
    rewriting_choices.evenly = choices.seed && !kind.stochastic;
    rewriting_choices.random_tables = choices.random_tables;
    const Rewriting rewriting(system, rewriting_choices, budget);
    ModuleString word = derive(rewriting, n, choices.tables, budget);
    return figure(system, rewriting.rules().kinds, std::move(word), n, rewriting_choices.seed,
                  budget);
}

std::unique_ptr<Figure> figure(const LSystem& system, const Word& word, std::uint64_t n,
                               const Budget& budget) {
    std::vector<Word> images;
    for (Symbol a = 0; a < system.alphabet.size(); ++a) images.push_back(Word{a});
    D0L rules = make_d0l(std::make_shared<const Alphabet>(system.alphabet), word, std::move(images),
                         system.name);
    return std::make_unique<PlaneFigure>(system, std::move(rules), 0, n, budget);
}

std::unique_ptr<Figure> figure(const LSystem& system, const ModuleKinds& kinds, ModuleString word,
                               std::uint64_t n, std::uint64_t seed, const Budget& budget) {
    if (is_plain(system) && word.values.empty())
        return figure(system, letters(kinds, word), n, budget);
    return std::make_unique<ModuleFigure>(system, kinds, std::move(word), n, seed, budget);
}

}  // namespace algae
