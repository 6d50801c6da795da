#pragma once

#include <map>
#include <string>
#include <vector>

#include "system/expression.hpp"

namespace algae {

/// A system as a NetLogo setup procedure says it. Each character of a text is a letter.
struct NetlogoSystem {
    struct Rule {
        std::string letter;
        std::string successor;
        std::string command;
    };
    std::vector<Rule> rules;
    std::string chain;
    std::map<std::string, Quantity> numbers;  // d, delta, x0, y0, delta-0, k-shorten, d-delta, k
};

/// The command that a text stands for: itself where the model knows it, otherwise "". The model
/// knows F f + - [ ] and S, and * where k is set.
std::string netlogo_command(const std::string& text, bool has_k);

/// The same system in the notation. The numbers must not lack d, delta and k-shorten, and [ and ]
/// must be commands of themselves only.
std::string netlogo_notation(const NetlogoSystem& system);

}  // namespace algae
