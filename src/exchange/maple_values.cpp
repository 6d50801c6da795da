#include "exchange/maple_values.hpp"

#include <utility>

#include "base/error.hpp"
#include "notation/characters.hpp"

namespace algae {

namespace {

const char* kind_name(const MapleValue& value) {
    switch (value.kind) {
        case MapleValue::Kind::text:
            return "a string";
        case MapleValue::Kind::list:
            return "a list";
        case MapleValue::Kind::function:
            return "a function";
        case MapleValue::Kind::parameters:
            return "the list of parameters";
        case MapleValue::Kind::expression:
            break;
    }
    return "a number";
}

}  // namespace

MapleValues::MapleValues(const Scanner& scanner, const MapleWorksheet& sheet)
    : scanner_(scanner), sheet_(sheet) {
    for (const auto& [name, offset, value] : sheet.assignments) {
        const std::string other = bare_name(value);
        ends_[name] = other.empty() ? &value : ends_.at(other);  // which was assigned before
        if (resolved(value).kind == MapleValue::Kind::expression)
            numbers_[name] = worked_out(checked(value, "a number"));
    }
}

const MapleValue& MapleValues::resolved(const MapleValue& value) const {
    const std::string name = bare_name(value);
    if (name.empty()) return value;
    const auto found = ends_.find(name);
    if (found == ends_.end()) fail(value, "nothing is assigned to " + quoted(name) + " before");
    return found->second->kind == MapleValue::Kind::expression ? value : *found->second;
}

const MapleValue& MapleValues::text(const MapleValue& value, const std::string& what) const {
    const MapleValue& found = resolved(value);
    if (found.kind != MapleValue::Kind::text)
        fail(value, "expected " + what + ", found " + kind_name(found));
    return found;
}

const MapleValue& MapleValues::list(const MapleValue& value, const std::string& what) const {
    const MapleValue& found = resolved(value);
    if (found.kind != MapleValue::Kind::list)
        fail(value, "expected " + what + ", found " + kind_name(found));
    return found;
}

const MapleExpression& MapleValues::checked(const MapleValue& value,
                                            const std::string& what) const {
    const MapleValue& found = resolved(value);
    if (found.kind != MapleValue::Kind::expression)
        fail(value, "expected " + what + ", found " + kind_name(found));
    for (const auto& [name, offset] : value.expression.names)
        if (!numbers_.contains(name)) {
            const MapleValue* assigned = sheet_.find(name);
            scanner_.fail_at(offset, assigned
                                         ? "expected a number, and " + quoted(name) + " is " +
                                               kind_name(resolved(*assigned))
                                         : "nothing is assigned to " + quoted(name) + " before");
        }
    return value.expression;
}

Quantity MapleValues::worked_out(const MapleExpression& expression) const {
    try {
        return evaluate(expression.expression, [&](const std::string& name) {
            const auto found = numbers_.find(name);
            return found == numbers_.end() ? nullptr : &found->second;
        });
    } catch (const Diagnostics& error) {
        scanner_.fail_at(expression.offset, error.findings().front().message);
    }
}

const Expression& MapleValues::number(const MapleValue& value, const std::string& what) {
    const MapleExpression& expression = checked(value, what);
    std::vector<const MapleExpression*> open{&expression};
    while (!open.empty()) {
        const MapleExpression* next = open.back();
        open.pop_back();
        for (const auto& [name, offset] : next->names)
            if (used_.insert(name).second) open.push_back(&sheet_.find(name)->expression);
    }
    return expression.expression;
}

Quantity MapleValues::quantity(const MapleValue& value, const std::string& what) const {
    return worked_out(checked(value, what));
}

Quantity MapleValues::setting(const MapleValue& value, const std::string& what) {
    Quantity found = quantity(value, what);
    if (found.exact) return algae::quantity(*found.exact);
    found.expression = number(value, what);
    return found;
}

Rational MapleValues::rational(const MapleValue& value, const std::string& what) const {
    const Quantity found = quantity(value, what);
    if (!found.exact) fail(value, "expected " + what + " without roots and functions");
    return *found.exact;
}

std::vector<std::pair<std::string, Quantity>> MapleValues::constants() const {
    std::vector<std::pair<std::string, Quantity>> all;
    for (const auto& [name, offset, value] : sheet_.assignments)
        if (used_.contains(name)) {
            all.emplace_back(name, numbers_.at(name));
            all.back().second.expression = value.expression.expression;
        }
    return all;
}

}  // namespace algae
