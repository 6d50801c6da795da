#pragma once

#include <string>

#include "system/lsystem.hpp"

namespace algae {

/// Which of the procedures of the worksheet a call is for. Used within this room only, as all here.
enum class MapleForm { strings, stochastic, parametric };

/// What a symbol of the notation is to the turtle of a procedure.
enum class MapleMeaning {
    same,    // the same
    none,    // nothing, and something in the notation: the interpretation leaves it out
    refused  // nothing, and in the notation a turn in space that cannot be left out
};
MapleMeaning maple_meaning(MapleForm form, const std::string& symbol);

/// How many parameters the turtle asks of a module: one or more, none, or any number.
enum class MapleNeed { any, one, none };
MapleNeed maple_need(const std::string& symbol);

/// Whether a module of this name is rewritten by a function: it is a letter from A to Z.
bool is_maple_capital(const std::string& symbol);

/// The form that says a system. Throws Error that names a rule, a setting or a symbol which none says.
MapleForm checked_maple_form(const LSystem& system);

}  // namespace algae
