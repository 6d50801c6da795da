#pragma once

#include <memory>
#include <string>
#include <vector>

#include "system/lsystem.hpp"
#include "system/view.hpp"

namespace algae {

/// A deterministic system with interactions, DIL: what a letter becomes depends on the letters
/// beside it (Rozenberg and Salomaa 1980, VI). Words have no brackets.
struct IL {
    struct Rule {
        Word left, right;  // contexts, read from left to right; empty ones match anywhere
        Word successor;
    };
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    std::vector<std::vector<Rule>> rules;  // by symbol, in the order in which they are tried
    std::vector<char> ignored;             // by symbol: not seen when contexts are matched
    std::string name;
};

/// The system as a deterministic IL system over plain letters, if it is one. Of the rules that
/// match a letter the one with the longest contexts is used, and of equally long ones the first in
/// the file; a letter that none matches stays as it is. Two rules with the same letter and contexts
/// are refused. O(size of the system).
View<IL> as_il(const LSystem& system);

/// The same system over another alphabet that has all its symbols by name: letters that it does not
/// know stay as they are. Throws Error if a symbol is missing there.
IL over(const IL& system, std::shared_ptr<const Alphabet> alphabet);

}  // namespace algae
