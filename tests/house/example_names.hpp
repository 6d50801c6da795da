#pragma once
// The names that examples in the documentation of src/**/*.hpp may use without introducing them.

#include <string>
#include <string_view>
#include <vector>

namespace algae::examples {

using namespace std::string_literals;

}  // namespace algae::examples
