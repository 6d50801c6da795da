#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace algae {

/// What a module of a Brno file looks like.
struct BrnoPrimitive {
    char kind = 0;      // C a cylinder, P a line, S a ball; 0 is not to be seen
    long diameter = 0;  // of a cylinder and a ball
    long length = 0;    // of a cylinder and a line

    bool operator==(const BrnoPrimitive&) const = default;
};

/// The letters that a turtle knows besides modules.
inline constexpr const char* brno_turtle_symbols = "+-&^\\/|[]{}!";

/// A D0L system as a Brno file says it.
struct BrnoSystem {
    std::map<char, BrnoPrimitive> modules;
    std::string axiom;
    std::map<char, long> angles;                      // by L, U, H, in degrees
    std::vector<std::pair<char, std::string>> rules;  // in the order of the file
};

/// The symbols that turn about this vector, one way and the other: "+-" of U.
///
/// Example: brno_turns('U') == std::string("+-")
const char* brno_turns(char vector);

/// The same system in the notation. All lines that draw are plain steps where they are equally
/// long; otherwise modules are interpreted with their measures.
///
/// Example: brno_notation({{{'F', {'P', 0, 1}}}, "F", {}, {}}) == "axiom F\n"
std::string brno_notation(const BrnoSystem& system);

/// The same system as a file. No section is empty: what one would say of nothing is added.
std::string brno_text(BrnoSystem system, const std::string& title);

}  // namespace algae
