#pragma once

#include <string>

#include "base/budget.hpp"

namespace algae::cli {

/// Prints a D0L system whose lengths are the sequence: terms "1,1,2,3,5,8", a recurrence
/// "a(n) = a(n-1) + a(n-2); 1, 1" or a polynomial "n^2+1". Throws Error if it cannot be read. Returns the
/// exit status: 1 if there is no such system, 3 if none was found.
int growth_realise(const std::string& specification, bool json, const Budget& budget);

}  // namespace algae::cli
