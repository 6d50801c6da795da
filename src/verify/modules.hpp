#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "exact/rational.hpp"
#include "verify/field.hpp"

namespace algae::verify {

/// A letter with its parameters.
struct Module {
    std::string letter;
    std::vector<double> values;
    auto operator<=>(const Module&) const = default;
};
using Modules = std::vector<Module>;

/// An expression as a tree.
struct Term {
    enum class Kind { number, parameter, operation };
    Kind kind = Kind::number;
    double number = 0;
    std::string name;  // of a parameter or an operation
    std::vector<Term> parts;
};

/// A system whose words are derived module by module.
struct ModuleSystem {
    struct Rule {
        std::string letter;
        std::vector<std::string> parameters;
        bool looks_around = false;  // it has contexts, or modules elsewhere
        std::optional<Term> condition;
        std::optional<Rational> probability;
        std::vector<std::pair<std::string, std::vector<Term>>> successor;
    };
    Modules axiom;
    std::vector<Rule> rules;
};

/// Throw Error where the field is not as CERTIFICATES.md says.
ModuleSystem module_system(const Field& field);
Modules modules(const Field& field);
Rational probability(const Field& field);

/// The probability that a word derives the other in so many steps, where no rule looks around: by
/// recursion, the probability that a module derives a part of the other word being the sum over its
/// rules of that of its successor in one step less, and that of a word the sum over all places where
/// what its first modules derive may end. Cubic in the length of the other word. Throws Flaw (at
/// `proof`) where rules leave a choice that has no probabilities or a value does not exist, BoundReached
/// where a rule looks around or uses a function that is not arithmetic.
Rational chance(const ModuleSystem& system, const Modules& from, const Modules& to,
                const Integer& steps, const Field& proof, const Budget& budget);

}  // namespace algae::verify
