#pragma once

#include <map>
#include <set>
#include <string>

#include "exchange/maple_worksheet.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// What the values of a worksheet come to: names looked up, numbers worked out. Used within this room
/// only.
class MapleValues {
public:
    /// Works out every assignment of a number, and fails where one has no value. Both must outlive it.
    MapleValues(const Scanner& scanner, const MapleWorksheet& sheet);

    /// The value, or what the name that it is stands for, unless that is a number.
    const MapleValue& resolved(const MapleValue& value) const;
    /// Fail unless it is one of the kind; `what` is "a list of rules".
    const MapleValue& text(const MapleValue& value, const std::string& what) const;
    const MapleValue& list(const MapleValue& value, const std::string& what) const;

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

}  // namespace algae
