#pragma once
// What the sources that read and print Maple worksheets share.

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exchange/detail/scanner.hpp"
#include "system/system.hpp"

namespace algae {

/// An arithmetic expression of a Maple worksheet in the terms of the notation: sines and their like
/// take degrees, ln is log, Pi a number.
struct MapleExpression {
    Expression expression;  // its names are those below, and "L[2]" of a list of parameters L
    std::vector<std::pair<std::string, std::size_t>> names;  // with their offsets in the text
    std::size_t offset = 0;
    std::size_t most_index = 0;  // the greatest in L[...]
};

/// A value in a Maple worksheet: what stands behind `:=`, between commas.
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

/// What the values of a worksheet come to: names looked up, numbers worked out.
class MapleValues {
public:
    /// Works out every assignment of a number, and fails where one has no value. Both must outlive it.
    MapleValues(const Scanner& scanner, const MapleWorksheet& sheet);

    /// The value, or what the name that it is stands for, unless that is a number.
    const MapleValue& resolved(const MapleValue& value) const;
    /// Fail unless it is of the kind; `what` is "a list of rules".
    const MapleValue& of_kind(MapleValue::Kind kind, const MapleValue& value,
                              const std::string& what) const;
    const MapleValue& text(const MapleValue& value, const std::string& what) const {
        return of_kind(MapleValue::Kind::text, value, what);
    }
    const MapleValue& list(const MapleValue& value, const std::string& what) const {
        return of_kind(MapleValue::Kind::list, value, what);
    }

    /// The expression, whose names become constants of the system. Fails unless it is a number.
    const Expression& number(const MapleValue& value, const std::string& what);
    /// The value of an expression without entries of lists.
    Quantity quantity(const MapleValue& value, const std::string& what) const;
    /// The same, as a number that is exact if it can be, with constants otherwise.
    Quantity setting(const MapleValue& value, const std::string& what);
    /// Fails unless it is rational.
    Rational rational(const MapleValue& value, const std::string& what) const;

    /// The constants that `number` and `setting` met, in the order of the worksheet.
    std::vector<std::pair<std::string, Quantity>> constants() const;
    bool is_constant(const std::string& name) const { return used_.contains(name); }

    [[noreturn]] void fail(const MapleValue& value, const std::string& message) const {
        scanner_.fail_at(value.offset, message);
    }
    const Scanner& scanner() const { return scanner_; }
    const MapleWorksheet& sheet() const { return sheet_; }

private:
    const MapleExpression& checked(const MapleValue& value, const std::string& what) const;
    Quantity worked_out(const MapleExpression& expression) const;

    const Scanner& scanner_;
    const MapleWorksheet& sheet_;
    std::map<std::string, const MapleValue*> ends_;  // what names stand for that is no other name
    std::map<std::string, Quantity> numbers_;
    std::set<std::string> used_;
};

/// Which of the procedures of the worksheet a call is for..
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
