#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace algae {

/// A line of a page: what it is, and its value in a column of its own.
inline std::string line(std::string_view label, std::string_view value) {
    return fmt::format("{:<24}{}\n", label, value);
}

}  // namespace algae
