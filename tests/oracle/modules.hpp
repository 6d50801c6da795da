#pragma once

#include <optional>
#include <string>
#include <vector>

#include "system/system.hpp"

namespace algae::oracle {

/// A module as on paper.
struct Module {
    std::string letter;
    std::vector<double> values;
    bool operator==(const Module&) const = default;
};
using Modules = std::vector<Module>;

/// The words of generations 0 to n of a deterministic system with parameters, contexts, conditions
/// on the rest of the word: every module in turn, every rule in turn, every combination in turn.
/// Nothing if some value on the way is not finite, or two rules with the same contexts match.
std::optional<std::vector<Modules>> module_words(const LSystem& system, unsigned n);

}  // namespace algae::oracle
