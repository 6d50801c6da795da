#pragma once
// Systems within systems by the definition: every word is derived anew from the axiom wherever an
// expression names it, and nothing is remembered.

#include <optional>
#include <string>

#include "system/system.hpp"

namespace algae::oracle {

struct NestedWord {
    std::optional<std::string> text;
    bool too_much = false;  // it was not worked out: the work would take too long
};

/// The word of generation n as text, of a deterministic system without contexts whose expressions are
/// made of + - * relations & and |, max, length, words in quotes and words of systems. Nothing where
/// some value does not exist, two rules match, or words need each other in a circle. Names of symbols
/// must be single letters.
NestedWord nested_word(const LSystem& system, unsigned n);

}  // namespace algae::oracle
