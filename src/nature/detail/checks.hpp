#pragma once

// Checks of what a generator is made of.

#include <fmt/format.h>

#include <utility>

#include "exact/exact.hpp"

namespace algae {

/// Throws Error with this text, in which `{}` stand for the values, unless the condition holds.
///
/// Example: (require(1 < 2, "expected less than 2, found {}", 1), true)
template <class... Values>
void require(bool holds, fmt::format_string<Values...> text, Values&&... values) {
    if (!holds) throw Error(fmt::format(text, std::forward<Values>(values)...));
}

}  // namespace algae
