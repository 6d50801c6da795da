#pragma once
// What the evaluation of expressions shares among its .cpp files.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/rational.hpp"
#include "system/expression.hpp"

namespace algae {

/// A value on its way: exact as long as that is possible.
struct Value {
    std::optional<Rational> exact;
    double rounded = 0;
};

/// Values with more bits than this, numerator and denominator together, go on as doubles.
inline constexpr std::uint64_t longest_exact = 100'000;
std::uint64_t bits(const Rational& value);

/// Throws `Diagnostics` with this message at the place of an expression.
[[noreturn]] void fail(const Expression& at, std::string message);

/// The text of an expression, cut if it is long.
std::string shown(const Expression& expression);

/// The value, if it is finite; otherwise fails at the expression.
Value finite(Value value, const Expression& at);
Value exactly(const Rational& value, const Expression& at);
Value truth(bool value);

bool is_zero(const Value& value);
/// -1, 0 or 1; exact if both are.
int compare(const Value& left, const Value& right);

/// The value of a call with these arguments.
Value call(const Expression& at, const std::vector<Value>& values);

}  // namespace algae
