#include "environment/open_figure.hpp"

#include <utility>

#include "environment/open_modules.hpp"
#include "system/classes.hpp"

namespace algae {

std::unique_ptr<Figure> open_figure(const LSystem& system, std::uint64_t n, const Budget& budget,
                                    const FigureChoices& choices,
                                    std::shared_ptr<Environment> external) {
    if (!class_of(system).open) return figure(system, n, budget, choices);
    DerivedModules derived = open_modules(system, n, choices, std::move(external), budget);
    return figure(system, derived.kinds, std::move(derived.word), n, derived.seed, budget);
}

}  // namespace algae
