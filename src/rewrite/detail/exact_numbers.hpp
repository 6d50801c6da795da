#pragma once

#include <string>

#include "rewrite/rewrite.hpp"

namespace algae {

constexpr bool is_unary(Program::Operation operation) {
    return operation >= Program::Operation::negate && operation <= Program::Operation::log;
}

/// Why an operation has no value, in the words of `evaluate`.
std::string reason(Program::Operation operation, double x, double y, const Expression& at);

/// The value of an operation on numbers of exact arithmetic; of one with one operand `x` and `y` are both that. Throws
/// `Undefined` where there is no value, or where enclosures do not tell which it is; BoundReached for more than 10,000 digits.
double apply_exactly(Program::Operation operation, double x, double y, WordValues& numbers,
                     const Expression& at);

}  // namespace algae
