#include "turtle/figure.hpp"

#include <algorithm>
#include <utility>

#include "fold/interaction.hpp"
#include "system/il.hpp"
#include "turtle/module_figure.hpp"
#include "turtle/plane_figure.hpp"

namespace algae {

namespace {

/// Whether commands without parameters say all that a turtle is to do with words of letters.
bool is_plain(const LSystem& system) {
    const Settings& settings = system.settings;
    if (!settings.stamps.empty() || !settings.solids.empty() || !settings.surfaces.empty() ||
        settings.tropism)
        return false;
    return std::all_of(
        system.interpretation.begin(), system.interpretation.end(), [](const Production& rule) {
            return !rule.condition && !rule.probability && rule.predecessor.parameters.empty() &&
                   rule.successor.arguments.empty() && rule.successor.splices.empty();
        });
}

}  // namespace

std::unique_ptr<Figure> figure(const LSystem& system, std::uint64_t n, const Budget& budget,
                               const FigureChoices& choices) {
    const bool plain = is_plain(system);
    if (const View<D0L> rules = as_d0l(system); rules && plain)
        return std::make_unique<PlaneFigure>(system, *rules, n, n, budget);
    const bool picked = choices.seed || !choices.tables.empty();
    if (const View<IL> rules = as_il(system); rules && plain && !picked) {
        check_choices(system, n, choices);
        return figure(system, derive(*rules, n, budget), n, budget);
    }
    DerivedModules derived = derived_modules(system, n, choices, budget);
    return figure(system, derived.kinds, std::move(derived.word), n, derived.seed, budget);
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
