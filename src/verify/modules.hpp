#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/budget.hpp"
#include "exact/rational.hpp"
#include "verify/field.hpp"

namespace algae::verify {

/// A letter with its parameters.
struct Module {
    std::string letter;
    std::vector<double> values;
    bool operator==(const Module&) const = default;
    bool operator<(const Module& other) const {
        return std::tie(letter, values) < std::tie(other.letter, other.values);
    }
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
    /// A module in a rule: a letter and the names of its parameters.
    struct Pattern {
        std::string letter;
        std::vector<std::string> parameters;
        bool operator==(const Pattern&) const = default;
    };
    struct Rule {
        Pattern module;
        std::vector<Pattern> left, right, elsewhere;
        std::optional<Term> condition;
        std::optional<Rational> probability;
        std::vector<std::pair<std::string, std::vector<Term>>> successor;
    };
    Modules axiom;
    std::vector<Rule> rules;
    std::set<std::string> ignored;  // not seen when contexts are matched
};

/// Throw Error where the field is not as CERTIFICATES.md says.
ModuleSystem module_system(const Field& field);
Modules modules(const Field& field);
Rational probability(const Field& field);

/// What the names in the expressions of a rule stand for.
using Bindings = std::map<std::string, double>;

/// The value of an expression. Throws Flaw (at `proof`) where it does not exist, BoundReached where it
/// uses a function that is not arithmetic.
double value(const Term& term, const Bindings& names, const Field& proof);

/// What a module may become, with probabilities; nothing if it stays.
using Choices = std::vector<std::pair<Rational, Modules>>;

/// The choices of the module at a position of a word: of the rules that match there, those with the most
/// modules around it that are first in the system. Throws what `value` throws, and Flaw where they leave a
/// choice without probabilities that add up to 1.
Choices choices(const ModuleSystem& system, const Modules& word, std::size_t position,
                const Field& proof);

/// The probability that a word derives the other in so many steps. Where no rule looks around, by
/// recursion: the probability that a module derives a part of the other word being the sum over its
/// rules of that of its successor in one step less, and that of a word the sum over all places where
/// what its first modules derive may end; cubic in the length of the other word. Where some rule does, by
/// deriving all words; BoundReached if there are more than 10,000. Throws what `choices` throws.
Rational chance(const ModuleSystem& system, const Modules& from, const Modules& to,
                const Integer& steps, const Field& proof, const Budget& budget);

}  // namespace algae::verify
