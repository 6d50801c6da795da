#pragma once

#include <cstdint>
#include <string>

namespace algae {

// Pieces of the sentences that arguments are made of.

/// A number and what it counts.
///
/// Example: counted(1, "step") + ", " + counted(2, "step") == "1 step, 2 steps"
inline std::string counted(std::uint64_t count, const std::string& noun) {
    return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

/// The name of a family or system behind "a" or "an", as it is spoken.
///
/// Example: with_article("0L") + ", " + with_article("E0L") == "a 0L, an E0L"
inline std::string with_article(const std::string& name) {
    return (!name.empty() && (name.front() == 'E' || name.front() == 'I') ? "an " : "a ") + name;
}

}  // namespace algae
