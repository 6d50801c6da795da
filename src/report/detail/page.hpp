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

inline constexpr std::size_t entries_shown = 12;  // of a list on a page

/// The first entries of a list; where there are more, `rest` behind them.
template <class Things, class Text>
std::string first_of(const Things& things, const char* between, Text text,
                     const std::string& rest) {
    std::string all;
    std::size_t count = 0;
    for (const auto& thing : things) {
        if (count == entries_shown) return all + between + rest;
        all += (count++ == 0 ? "" : between) + text(thing);
    }
    return all;
}

template <class Things, class Text>
std::string some_of(const Things& things, const char* between, Text text) {
    return first_of(things, between, text, "... (" + std::to_string(things.size()) + " in all)");
}

inline std::string number(std::uint64_t value) { return std::to_string(value); }

}  // namespace algae
