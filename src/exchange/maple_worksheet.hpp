#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exchange/maple_expression.hpp"
#include "exchange/scanner.hpp"

namespace algae {

/// A value in a Maple worksheet: what stands behind `:=`, between commas. Used within this room only.
struct MapleValue {
    enum class Kind { expression, text, list, function, parameters };
    Kind kind = Kind::expression;
    std::size_t offset = 0;
    MapleExpression expression;     // a bare name may stand for any value
    std::string text;               // of a string; its characters follow `offset`
    std::vector<MapleValue> items;  // of a list; of a function L -> [...] the list behind the arrow
    std::string parameters;         // L, of a function and of L itself in it
};

/// The name that an expression is, if it is nothing else; otherwise empty.
std::string bare_name(const MapleValue& value);

/// What a worksheet says to the procedures Lsystem and GRAFICO: the assignments and the one call.
struct MapleWorksheet {
    struct Assignment {
        std::string name;
        std::size_t offset = 0;
        MapleValue value;
    };
    std::vector<Assignment> assignments;
    std::map<std::string, std::size_t> assigned;  // the place in `assignments`, by name
    /// Where the turtle starts: PONTOA, ANGULO, SEGMENTO, vH, vL, vU as first assigned in the procedure
    /// GRAFICO or in the worksheet, whatever stands last before the call.
    std::map<std::string, MapleValue> start;
    std::vector<MapleValue> arguments;  // of the call
    std::size_t call = 0;               // its offset

    /// What this name is assigned; nullptr if nothing.
    const MapleValue* find(const std::string& name) const;
};

/// Reads statements that end in `;` or `:` up to the end: `restart`, `with(...)`, procedures, which are
/// skipped, assignments and one call `Lsystem(...)`. Fails on anything else, on names that are assigned
/// twice or used before, on no call, and with all their places on several.
MapleWorksheet read_maple_worksheet(Scanner& scanner);

}  // namespace algae
