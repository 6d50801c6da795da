#pragma once

namespace algae {

/// What Maple calls a function of the notation. Angles are degrees here and radians there.
struct MapleFunction {
    const char *name, *maple;
    enum class Angle { none, argument, value } angle = Angle::none;
};
inline constexpr MapleFunction maple_functions[] = {
    {"sqrt", "sqrt"},
    {"exp", "exp"},
    {"log", "ln"},
    {"log", "log"},
    {"abs", "abs"},
    {"floor", "floor"},
    {"ceil", "ceil"},
    {"min", "min"},
    {"max", "max"},
    {"sin", "sin", MapleFunction::Angle::argument},
    {"cos", "cos", MapleFunction::Angle::argument},
    {"tan", "tan", MapleFunction::Angle::argument},
    {"asin", "arcsin", MapleFunction::Angle::value},
    {"acos", "arccos", MapleFunction::Angle::value},
    {"atan", "arctan", MapleFunction::Angle::value}};

}  // namespace algae
