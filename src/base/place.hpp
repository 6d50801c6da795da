#pragma once
// base: what every room says when it cannot go on. Error, Place, Diagnostics, Budget; nothing else.

#include <cstddef>
#include <string>
#include <tuple>

namespace algae {

/// A place in a text: lines and columns count from 1, columns in characters (not bytes).
/// Line 0 means the file as a whole.
struct Place {
    std::string file;
    std::size_t line = 0;
    std::size_t column = 0;

    bool operator==(const Place&) const = default;
    bool operator<(const Place& other) const {
        return std::tie(file, line, column) < std::tie(other.file, other.line, other.column);
    }
};

/// "koch.lsys:3:11", or "koch.lsys" where the whole file is meant.
///
/// Example: to_string(Place{"koch.lsys", 3, 11}) == "koch.lsys:3:11"
std::string to_string(const Place& place);

}  // namespace algae
