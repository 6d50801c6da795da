#pragma once

// Checks of what a generator is made of.

#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <variant>

#include "exact/exact.hpp"

namespace algae {

/// A value in a message.
using Said = std::variant<std::int64_t, std::uint64_t, double, std::string_view>;

/// Throws Error with this text, in which `{}` stand for the values, unless the condition holds.
///
/// Example: (require(1 < 2, "expected less than 2, found {}", {1}), true)
void require(bool holds, std::string_view text, std::initializer_list<Said> values = {});

}  // namespace algae
