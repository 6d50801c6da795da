#pragma once

#include <string_view>
#include <vector>

#include "notation/reading.hpp"

namespace algae {

/// The arrow of a rule: what stands before it, in it and behind it.
struct Arrow {
    std::string_view left_side;
    std::string_view probability;  // of `-(p)->`; empty for `->`
    std::string_view right_side;
};

/// Splits a rule at its first arrow. `-(a)` where something must still come is no beginning of an
/// arrow but a module or a number: `-(a)-> b` has the predecessor -(a).
Arrow split_at_arrow(std::string_view rule, const char* arrow);

/// What stands before the arrow: contexts, predecessor, context condition and condition, into a
/// production. Throws `SyntaxError`.
void parse_left_side(std::string_view text, Lexicon& lexicon, const Source& source,
                     Production& production);

/// The names of all formal parameters of a production.
std::vector<std::string> parameters(const Production& production);

}  // namespace algae
