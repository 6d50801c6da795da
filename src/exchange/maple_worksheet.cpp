#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "exchange/detail/maple.hpp"

// Worksheets of Maple: what is assigned and called in them, and what the values come to.
//
// A worksheet uses the procedures Lsystem and GRAFICO, which usually stand in it too. Of Maple's language
// only this is read: assignments of numbers, strings, lists and functions L -> [...], `restart`, `with(...)`,
// and one call of Lsystem. Procedures are skipped to their `end proc`, but where GRAFICO's turtle starts is
// taken from its first assignments.
//
// Expressions are turned into those of the notation as they are read: angles are radians there and degrees
// here, so sin(x) becomes sin(x*180/pi), and x*Pi/180 within it is taken back to x, so that what is printed
// reads back unchanged. A name must be assigned above its use, so values are worked out in one pass
// (`MapleValues`); those that a system really uses become its constants.

namespace algae {

namespace {

constexpr std::size_t most_depth = 100, most_operations = 150, longest_number = 1000;
constexpr const char nothing_assigned[] = "nothing is assigned to {} before";

/// A letter or `_`, then letters, digits and `_`; empty if the next token is none. Not gone past.
std::string next_maple_name(Scanner& scanner) {
    const std::string_view rest = scanner.rest();
    if (!rest.empty() && is_digit(static_cast<unsigned char>(rest[0]))) return "";
    const auto* end =
        std::ranges::find_if_not(rest, [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    return {rest.begin(), end};
}

Expression binary(const std::string& name, Expression left, Expression right) {
    return made_expression(Expression::Kind::binary, name, {std::move(left), std::move(right)});
}

const Expression& pi() {
    static const Expression value =
        number_expression(Rational("3.14159265358979323846264338327950288419716939937511"));
    return value;
}

/// Whether it is x*first/second.
bool is_scaled(const Expression& expression, const Expression& first, const Expression& second) {
    return expression.kind == Expression::Kind::binary && expression.name == "/" &&
           expression.operands[1] == second &&
           expression.operands[0].kind == Expression::Kind::binary &&
           expression.operands[0].name == "*" && expression.operands[0].operands[1] == first;
}

/// x*first/second, or y if x is y*second/first.
Expression scaled(Expression x, const Expression& first, const Expression& second) {
    if (is_scaled(x, second, first)) return Expression(x.operands[0].operands[0]);
    return binary("/", binary("*", std::move(x), first), second);
}

using Binding = ExpressionDialect::Binding;
const ExpressionDialect maple{{{"+", "+", Binding::sum},
                               {"-", "-", Binding::sum},
                               {"*", "*", Binding::product},
                               {"/", "/", Binding::product},
                               {"^", "^", Binding::power},
                               {"**", "^", Binding::power}},
                              {{"+", "", Binding::prefix}, {"-", "-", Binding::prefix}},
                              ExpressionDialect::Powers::in_brackets};

/// Reads an expression. `parameters` is the name of the list of the function in which it stands, or
/// empty. Fails on what it does not know, on brackets more than 100 deep, and on more than 150 operators
/// and calls.
class ExpressionReader {
public:
    ExpressionReader(Scanner& scanner, const std::string& parameters)
        : scanner_(scanner), parameters_(parameters) {
        read_.offset = scanner.offset();
    }

    MapleExpression all() {
        read_.expression = sum();
        return std::move(read_);
    }

private:
    void count(std::size_t offset) {
        if (++operations_ > most_operations)
            scanner_.fail_at(offset,
                             fmt::format("an expression with more than {} operators and calls",
                                         most_operations));
    }

    Expression sum() {
        if (++depth_ > most_depth)
            scanner_.fail_at(scanner_.offset(),
                             fmt::format("an expression nested more than {} deep", most_depth));
        Expression read = scanner_.expression(
            maple, [&] { return atom(); }, [&](std::size_t offset) { count(offset); }, unscaled);
        --depth_;
        return read;
    }

    /// x where it is x*180/Pi of an x that is scaled already.
    static Expression unscaled(Expression read) {
        static const Expression half_turn = number_expression(180);
        return is_scaled(read, half_turn, pi())
                   ? scaled(Expression(read.operands[0].operands[0]), half_turn, pi())
                   : read;
    }

    Expression atom() {
        const std::string_view rest = scanner_.rest();
        if (scanner_.take("(")) {
            Expression inside = sum();
            scanner_.expect(")", "");
            return inside;
        }
        if (!rest.empty() && (std::isdigit(static_cast<unsigned char>(rest[0])) || rest[0] == '.'))
            return literal();
        const std::size_t where = scanner_.offset();
        const std::string name = next_maple_name(scanner_);
        if (name.empty()) scanner_.fail("a number, a name or '('");
        if (name == parameters_) return parameter();
        scanner_.take(name);
        if (name == "Pi") return pi();
        if (scanner_.rest().starts_with("(")) return call(name, where);
        if (scanner_.rest().starts_with("["))
            scanner_.fail_at(where,
                             parameters_.empty()
                                 ? "expected a number, found an entry of " + algae::quoted(name)
                                 : "expected an entry of " + algae::quoted(parameters_) +
                                       ", found one of " + algae::quoted(name));
        read_.names.emplace_back(name, where);
        return made_expression(Expression::Kind::name, name, {});
    }

    Expression literal() {
        const std::string_view number = scanner_.rest().substr(0, number_size(scanner_.rest()));
        if (number.empty()) scanner_.fail("a number");
        const std::string text = plain_number(number);
        Rational value;
        try {
            if (text.size() > longest_number) throw Error("");
            value = Rational(text);
        } catch (const Error&) {
            scanner_.fail_at(scanner_.offset(),
                             fmt::format("the number {} is out of range", algae::quoted(text)));
        }
        scanner_.take(number);
        return number_expression(value);
    }

    Expression parameter() {
        scanner_.take(parameters_);
        scanner_.expect("[", "behind the list " + parameters_);
        const std::size_t where = scanner_.offset();
        const Rational index = scanner_.number("the number of a parameter", 1, 1000);
        if (!index.is_integer())
            scanner_.fail_at(where,
                             fmt::format("expected a whole number, found {}", to_string(index)));
        scanner_.expect("]", "");
        const std::string text = to_string(index);
        read_.most_index = std::max(read_.most_index, std::stoul(text));
        return made_expression(Expression::Kind::name, parameters_ + "[" + text + "]", {});
    }

    Expression call(const std::string& name, std::size_t where) {
        count(where);
        const auto* function =
            std::find_if(std::begin(maple_functions), std::end(maple_functions),
                         [&](const MapleFunction& one) { return name == one.maple; });
        if (function == std::end(maple_functions) && name != "evalf") {
            std::string known;
            for (const MapleFunction& one : maple_functions) known += std::string(one.maple) + ", ";
            scanner_.fail_at(where, fmt::format("expected one of {}evalf, found the function {}",
                                                known, algae::quoted(name)));
        }
        scanner_.expect("(", "");
        std::vector<Expression> arguments{sum()};
        if (name == "evalf") {
            scanner_.expect(")", "behind the argument of evalf");
            return std::move(arguments[0]);
        }
        const Arity arity = *function_arity(function->name);
        while (arguments.size() < arity.least || arity.or_more) {
            if (!scanner_.take(",")) break;
            count(scanner_.offset());
            arguments.push_back(sum());
        }
        if (arguments.size() < arity.least) scanner_.fail("',' and another argument of " + name);
        scanner_.expect(")", "behind the arguments of " + name);
        if (function->angle == MapleFunction::Angle::argument)
            arguments[0] = scaled(std::move(arguments[0]), number_expression(180), pi());
        Expression value =
            made_expression(Expression::Kind::call, function->name, std::move(arguments));
        if (function->angle == MapleFunction::Angle::value)
            return scaled(std::move(value), pi(), number_expression(180));
        return value;
    }

    Scanner& scanner_;
    const std::string& parameters_;
    MapleExpression read_;
    std::size_t depth_ = 0, operations_ = 0;
};

const char* kind_name(const MapleValue& value) {
    constexpr const char* names[] = {"a number", "a string", "a list", "a function",
                                     "the list of parameters"};
    return names[static_cast<std::size_t>(value.kind)];
}

const char* const statements_known = "an assignment, restart, with(...) or a call Lsystem(...)";

bool is_start(std::string_view name) {
    constexpr std::string_view known[] = {"PONTOA", "ANGULO", "SEGMENTO", "vH", "vL", "vU"};
    return std::ranges::count(known, name) > 0;
}

class Reader {
public:
    explicit Reader(Scanner& scanner) : scanner_(scanner) {}

    MapleWorksheet all() {
        while (!scanner_.at_end()) {
            if (scanner_.take(";") || scanner_.take(":")) continue;  // an empty statement
            statement();
        }
        if (calls_.empty()) scanner_.fail("a call Lsystem(...)");
        if (calls_.size() > 1) {
            std::vector<Diagnostic> findings;
            for (std::size_t i = 1; i < calls_.size(); ++i)
                findings.push_back(scanner_.source().finding(
                    calls_[i], "another call of Lsystem; expected one, the first is in " +
                                   line_of(calls_[0])));
            throw Diagnostics(std::move(findings));
        }
        return std::move(sheet_);
    }

private:
    std::string line_of(std::size_t offset) const {
        return "line " + std::to_string(scanner_.source().place(offset).line);
    }

    void statement() {
        const std::size_t where = scanner_.offset();
        const std::string name = next_maple_name(scanner_);
        if (name.empty()) scanner_.fail(statements_known);
        scanner_.take(name);
        if (scanner_.take(":=")) {
            if (next_maple_name(scanner_) == "proc")
                procedure(name == "GRAFICO");
            else
                assign(name, where);
        } else if (name == "with") {
            scanner_.expect("(", "behind with");
            if (next_maple_name(scanner_).empty()) scanner_.fail("the name of a package");
            scanner_.take(next_maple_name(scanner_));
            scanner_.expect(")", "behind the name of a package");
        } else if (name == "Lsystem") {
            call(where);
        } else if (name != "restart") {
            scanner_.fail_at(
                where, fmt::format("expected {}, found {}", statements_known, algae::quoted(name)));
        }
        if (!scanner_.take(";") && !scanner_.take(":"))
            scanner_.fail("';' or ':' at the end of the statement");
    }

    void assign(const std::string& name, std::size_t where) {
        for (const char* kept : {"D", "I", "Pi"})
            if (name == kept)
                scanner_.fail_at(
                    where,
                    fmt::format("Maple keeps the name {} for itself: nothing can be assigned to it",
                                name));
        MapleValue read = value("", 0);
        if (is_start(name) && calls_.empty()) sheet_.start[name] = read;
        const auto [at, is_new] = sheet_.assigned.emplace(name, sheet_.assignments.size());
        if (!is_new)
            scanner_.fail_at(where,
                             fmt::format("{} is assigned twice, first in {}", algae::quoted(name),
                                         line_of(sheet_.assignments[at->second].offset)));
        sheet_.assignments.push_back({name, where, std::move(read)});
    }

    void call(std::size_t where) {
        calls_.push_back(where);
        scanner_.expect("(", "behind Lsystem");
        std::vector<MapleValue> arguments;
        in_call_ = true;
        do arguments.push_back(value("", 0));
        while (scanner_.take(","));
        in_call_ = false;
        scanner_.expect(")", "behind the arguments of Lsystem");
        if (calls_.size() > 1) return;
        sheet_.arguments = std::move(arguments);
        sheet_.call = where;
        // What is assigned behind the call comes too late for it.
        for (const auto& assignment : sheet_.assignments)
            if (assignment.value.kind == MapleValue::Kind::function) check_names(assignment.value);
    }

    /// Goes past a procedure. What GRAFICO assigns first is where its turtle starts.
    void procedure(bool is_turtle) {
        const std::size_t where = scanner_.offset();
        std::map<std::string, MapleValue> start;
        std::size_t depth = 0;
        while (!scanner_.at_end()) {
            const std::string name = next_maple_name(scanner_);
            if (name.empty()) {
                if (scanner_.rest().starts_with('"'))
                    scanner_.quoted("a string");
                else
                    scanner_.character("a procedure");
                continue;
            }
            scanner_.take(name);
            if (name == "proc" && ++depth > most_depth)
                scanner_.fail_at(where, "procedures nested more than 100 deep");
            if (name == "end" && next_maple_name(scanner_) == "proc") {
                scanner_.take("proc");
                if (--depth > 0) continue;
                if (is_turtle && calls_.empty()) sheet_.start = std::move(start);
                return;
            }
            if (is_turtle && is_start(name) && !start.contains(name) && scanner_.take(":="))
                start[name] = value("", 0);
        }
        scanner_.fail_at(where, "'proc' without 'end proc'");
    }

    MapleValue value(const std::string& parameters, std::size_t depth) {
        if (depth > most_depth)
            scanner_.fail_at(scanner_.offset(),
                             fmt::format("lists nested more than {} deep", most_depth));
        MapleValue read;
        read.offset = scanner_.offset();
        const std::string_view rest = scanner_.rest();
        if (rest.starts_with('"')) {
            read.kind = MapleValue::Kind::text;
            read.text = scanner_.quoted("a string");
            return read;
        }
        if (scanner_.take("[")) {
            read.kind = MapleValue::Kind::list;
            if (scanner_.take("]")) return read;
            do read.items.push_back(value(parameters, depth + 1));
            while (scanner_.take(","));
            scanner_.expect("]", "at the end of the list");
            return read;
        }
        const std::string name = next_maple_name(scanner_);
        if (!name.empty() && is_alone(rest, name)) {
            if (name == parameters) {
                scanner_.take(name);
                read.kind = MapleValue::Kind::parameters;
                read.parameters = name;
                return read;
            }
            if (depth == 0 && !in_call_ && behind(rest, name).starts_with("->"))
                return function(name);
        }
        read.expression = ExpressionReader(scanner_, parameters).all();
        if (parameters.empty()) check_names(read);
        return read;
    }

    /// What stands behind a name that begins the rest of the text.
    static std::string_view behind(std::string_view rest, const std::string& name) {
        const std::size_t next = rest.find_first_not_of(" \t", name.size());
        return next == std::string_view::npos ? std::string_view() : rest.substr(next);
    }
    static bool is_alone(std::string_view rest, const std::string& name) {
        return !behind(rest, name).starts_with('[');
    }

    MapleValue function(const std::string& parameters) {
        MapleValue read;
        read.kind = MapleValue::Kind::function;
        read.offset = scanner_.offset();
        read.parameters = parameters;
        scanner_.take(parameters);
        scanner_.expect("->", "");
        if (!scanner_.rest().starts_with('['))
            scanner_.fail("'[' and the modules of the successor");
        read.items.push_back(value(parameters, 1));
        return read;
    }

    /// Names stand for what was assigned before; N alone may be left open, as the last argument.
    void check_names(const MapleValue& value) const {
        for (const auto& [name, where] : value.expression.names)
            if (!sheet_.assigned.contains(name) && !(in_call_ && name == "N"))
                scanner_.fail_at(where, fmt::format(nothing_assigned, algae::quoted(name)));
        for (const MapleValue& item : value.items) check_names(item);
    }

    Scanner& scanner_;
    MapleWorksheet sheet_;
    std::vector<std::size_t> calls_;
    bool in_call_ = false;
};

}  // namespace

std::string bare_name(const MapleValue& value) {
    const bool is_name = value.kind == MapleValue::Kind::expression &&
                         value.expression.expression.kind == Expression::Kind::name &&
                         value.expression.names.size() == 1;
    return is_name ? value.expression.expression.name : "";
}

const MapleValue* MapleWorksheet::find(const std::string& name) const {
    const auto found = assigned.find(name);
    return found == assigned.end() ? nullptr : &assignments[found->second].value;
}

MapleWorksheet read_maple_worksheet(Scanner& scanner) { return Reader(scanner).all(); }

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
    if (found == ends_.end()) fail(value, fmt::format(nothing_assigned, algae::quoted(name)));
    return found->second->kind == MapleValue::Kind::expression ? value : *found->second;
}

const MapleValue& MapleValues::of_kind(MapleValue::Kind kind, const MapleValue& value,
                                       const std::string& what) const {
    const MapleValue& found = resolved(value);
    if (found.kind != kind)
        fail(value, fmt::format("expected {}, found {}", what, kind_name(found)));
    return found;
}

const MapleExpression& MapleValues::checked(const MapleValue& value,
                                            const std::string& what) const {
    of_kind(MapleValue::Kind::expression, value, what);
    for (const auto& [name, offset] : value.expression.names)
        if (!numbers_.contains(name)) {
            const MapleValue* assigned = sheet_.find(name);
            if (!assigned)
                scanner_.fail_at(offset, fmt::format(nothing_assigned, algae::quoted(name)));
            scanner_.fail_at(offset,
                             fmt::format("expected a number, and {} is {}", algae::quoted(name),
                                         kind_name(resolved(*assigned))));
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
    if (!found.exact) fail(value, fmt::format("expected {} without roots and functions", what));
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
