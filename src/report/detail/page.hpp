#pragma once

#include <string>
#include <string_view>

namespace algae {

/// A line of a page: what it is, and its value in a column of its own.
inline std::string line(std::string_view label, std::string_view value) {
    constexpr std::size_t column = 24;
    std::string text(label);
    if (text.size() < column) text.resize(column, ' ');
    return text.append(value) + '\n';
}

}  // namespace algae
