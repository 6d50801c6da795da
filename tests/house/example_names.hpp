#pragma once
// The names that examples in the documentation of src/**/*.hpp may use without introducing them.

#include <string>
#include <string_view>
#include <vector>

#include "model/model.hpp"
#include "notation/notation.hpp"

namespace algae::examples {

using namespace std::string_literals;

inline Expression parsed(std::string_view text) { return read_expression(text); }

}  // namespace algae::examples
