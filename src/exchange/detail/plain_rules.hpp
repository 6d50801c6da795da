#pragma once

#include <string>
#include <vector>

#include "notation/notation.hpp"
#include "system/system.hpp"

namespace algae {

struct Model;

/// A module as the turtle meets it: a symbol and the values of its parameters.
struct TurtleModule {
    Symbol symbol = 0;
    std::vector<Quantity> parameters;
};

/// Checks that a format can say a system whose axiom and rules are words of letters without
/// parameters, and whose rules have no contexts and conditions; several rules for a letter only if
/// `choices`. Throws Error that names what `format` ("brno") cannot say.
void check_plain_rules(const LSystem& system, const std::string& format, bool choices);

/// What stands for a letter once `interpret` rules have been applied until none matches.
///
/// Throws Error that names the interpretation if it has contexts, conditions, probabilities or
/// parameters on its left side, goes round in circles or gives more than 1000 modules.
std::vector<TurtleModule> interpreted(const LSystem& system, Symbol letter,
                                      const std::string& format);

/// The settings that move every figure but are no matter of words: throws Error where a format
/// cannot say that there are a tropism, environments, solids of this system and so on. Titles,
/// colours, cameras, line widths, seeds and what is expected are left out by all formats.
void check_plain_settings(const Model& system, const std::string& format);

/// Throws Error: "bush: brno cannot say ...", with the system's name if it has one.
[[noreturn]] void cannot_say(const LSystem& system, const std::string& format,
                             const std::string& what);

/// Throws Error: "bush.lsys:3:1: brno cannot say the rule A -> B: " and why.
[[noreturn]] void cannot_say(const LSystem& system, const std::string& format,
                             const Production& rule, const std::string& why);

}  // namespace algae
