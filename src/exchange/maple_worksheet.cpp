#include "exchange/maple_worksheet.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/error.hpp"
#include "notation/characters.hpp"

namespace algae {

namespace {

constexpr std::size_t most_depth = 100;
const char* const statements_known = "an assignment, restart, with(...) or a call Lsystem(...)";

bool is_start(const std::string& name) {
    for (const char* known : {"PONTOA", "ANGULO", "SEGMENTO", "vH", "vL", "vU"})
        if (name == known) return true;
    return false;
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
                where, std::string("expected ") + statements_known + ", found " + quoted(name));
        }
        if (!scanner_.take(";") && !scanner_.take(":"))
            scanner_.fail("';' or ':' at the end of the statement");
    }

    void assign(const std::string& name, std::size_t where) {
        for (const char* kept : {"D", "I", "Pi"})
            if (name == kept)
                scanner_.fail_at(where, "Maple keeps the name " + name +
                                            " for itself: nothing can be assigned to it");
        MapleValue read = value("", 0);
        if (is_start(name) && calls_.empty()) sheet_.start[name] = read;
        const auto [at, is_new] = sheet_.assigned.emplace(name, sheet_.assignments.size());
        if (!is_new)
            scanner_.fail_at(where, quoted(name) + " is assigned twice, first in " +
                                        line_of(sheet_.assignments[at->second].offset));
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
                             "lists nested more than " + std::to_string(most_depth) + " deep");
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
        read.expression = read_maple_expression(scanner_, parameters);
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
                scanner_.fail_at(where, "nothing is assigned to " + quoted(name) + " before");
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

}  // namespace algae
