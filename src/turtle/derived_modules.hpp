#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "rewrite/module_string.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// What is drawn where a system leaves a choice.
struct FigureChoices {
    std::optional<std::uint64_t> seed;  // none: 1 for systems with probabilities
    std::vector<std::size_t> tables;    // one for each step; none: by the schedule or the seed
    bool random_tables = false;         // by the seed, even if there is a schedule
};

/// A word for a turtle to walk.
struct DerivedModules {
    ModuleKinds kinds;
    ModuleString word;
    std::uint64_t seed = 1;  // for interpretations with probabilities
};

/// Throws Error if a turtle cannot draw generation `n` of the system, or would have to guess: it has
/// shape rules, communication modules, tables or several rules for a letter that nobody chose from.
void check_choices(const LSystem& system, std::uint64_t n, const FigureChoices& choices);

/// The word of generation `n` with its parameters, derived as Rewriting says.
///
/// Throws what check_choices and Rewriting throw.
///
/// Example: derived_modules(read_lsystem("axiom A(1); A(x) -> F(x)A(x*2)", ""), 3, {}).word.kinds.size() == 4
DerivedModules derived_modules(const LSystem& system, std::uint64_t n, const FigureChoices& choices,
                               const Budget& budget = {});

}  // namespace algae
