#pragma once

#include <map>
#include <optional>
#include <string>

#include "exact/rational.hpp"
#include "system/expression.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// What the parameters of a module are, as far as they matter to a turtle's way.
struct ModuleValues {
    std::optional<std::string> length;  // the name of the one that is a length
    std::map<std::string, Rational> numbers;
};

/// A number, or so many times the length of the module that a rule rewrites.
struct LengthMultiple {
    bool of_length = false;
    Expression factor;  // without names, shortened
};

/// An expression over a module's parameters and a system's constants as a multiple of its length.
/// Throws Error where it is none: x+1, x^2.
LengthMultiple multiple_of(const Expression& expression, const ModuleValues& values,
                           const LSystem& system);

/// The value of an expression that does not depend on the length. Throws Error where it is not
/// rational.
Rational exact_number(const Expression& expression, const ModuleValues& values,
                      const LSystem& system);

}  // namespace algae
