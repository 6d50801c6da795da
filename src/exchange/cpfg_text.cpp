#include <algorithm>
#include <utility>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/scanner.hpp"

// Texts of cpfg and L-Py before their meaning: comments, macros, and expressions.
//
// The preprocessor replaces names by the texts of `#define`, again and again; what comes of a macro stands where the macro stood, so that errors
// name a place of the file. In expressions of cpfg `^` groups from the left and a sign binds tighter than it; in Python a power groups from the
// right and binds tighter than a sign. Each operator is written with brackets, so the notation groups it the same.

namespace algae {

namespace {

[[noreturn]] void cpfg_fail(const Source& source, std::size_t place, const std::string& message) {
    throw Diagnostics({source.finding(std::min(place, source.text().size()), message)});
}
[[noreturn]] void cpfg_refuse(const Source& source, std::size_t place, const std::string& what,
                              const std::string& why) {
    cpfg_fail(source, place, what + " " + why);
}

class Preprocessor {
public:
    Preprocessor(const Source& source, const CpfgDialect& dialect)
        : source_(source), text_(source.text()), dialect_(dialect) {}

    /// Without comments, macros replaced; the part of L-Py that the editor saves is cut off.
    Placed preprocessed() {
        Placed out;
        std::string_view text = text_;
        if (dialect_.python) text = text.substr(0, text.find("###### INITIALISATION ######"));
        for (std::size_t i = 0; i < text.size();) {
            const bool line_begins = i == 0 || text[i - 1] == '\n';
            if (dialect_.python) {
                if (text[i] == '#') {
                    while (i < text.size() && text[i] != '\n') ++i;
                    continue;
                }
            } else {
                if (text.substr(i).starts_with("/*")) {
                    const std::size_t end = text.find("*/", i + 2);
                    if (end == std::string_view::npos) fail(i, "a comment that is never closed");
                    i = end + 2;
                    continue;
                }
                if (text.substr(i).starts_with("//")) {
                    while (i < text.size() && text[i] != '\n') ++i;
                    continue;
                }
                if (line_begins && text[i] == '#') {
                    const std::size_t next = directive(text, i);
                    // The line itself stays, empty: it can stand for the rules of a system.
                    if (next > 0 && text[next - 1] == '\n') out.add('\n', next - 1);
                    i = next;
                    continue;
                }
                if (is_left_out()) {
                    if (text[i] == '\n') out.add('\n', i);
                    ++i;
                    continue;
                }
                if (is_name_start(text[i]) && (i == 0 || !is_name_part(text[i - 1]))) {
                    i = expand(text, i, i, out, 0);
                    continue;
                }
            }
            if (text[i] != '\r') out.add(text[i], i);
            ++i;
        }
        if (!conditions_.empty()) fail(conditions_.back().place, "expected #endif, found none");
        return out;
    }

private:
    struct Macro {
        std::vector<std::string> parameters;
        bool takes = false;
        std::string body;
    };

    /// A line of the preprocessor; gives where the next line begins.
    std::size_t directive(std::string_view text, std::size_t at) {
        std::size_t end = at;
        std::string line;
        while (end < text.size() && text[end] != '\n') {
            if (text[end] == '\\' && end + 1 < text.size() && text[end + 1] == '\n') {
                end += 2;
                continue;
            }
            if (text.substr(end).starts_with("//")) {
                while (end < text.size() && text[end] != '\n') ++end;
                break;
            }
            if (text.substr(end).starts_with("/*")) {
                const std::size_t close = text.find("*/", end + 2);
                end = close == std::string_view::npos ? text.size() : close + 2;
                continue;
            }
            line += text[end++];
        }
        std::size_t i = 1;
        const auto word = [&] {
            while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
            std::string found;
            while (i < line.size() && is_name_part(line[i])) found += line[i++];
            return found;
        };
        const std::string kind = word();
        const std::size_t next = std::min(end + 1, text.size());
        if (kind == "if" || kind == "ifdef" || kind == "ifndef" || kind == "elif" ||
            kind == "else" || kind == "endif") {
            condition(kind, line.substr(std::min(i, line.size())), at);
            return next;
        }
        if (is_left_out()) return next;
        if (kind == "include" && dialect_.plus) {
            // The modules that it declares are known.
            if (line.find("<lpfgall.h>") != std::string::npos) return next;
        }
        if (kind == "undef") {
            macros_.erase(word());
            return next;
        }
        if (kind != "define")
            refuse(at, "#" + kind,
                   "is not read: expected #define, #undef or #if, with the other files put in");
        const std::string name = word();
        if (name.empty()) fail(at, "expected a name behind #define");
        Macro macro;
        if (i < line.size() && line[i] == '(') {
            macro.takes = true;
            for (++i; i < line.size() && line[i] != ')';) {
                const std::string parameter = word();
                if (parameter.empty()) fail(at, "expected names between the brackets of #define");
                macro.parameters.push_back(parameter);
                while (i < line.size() && (line[i] == ' ' || line[i] == ',')) ++i;
            }
            ++i;
        }
        macro.body = i < line.size() ? line.substr(i) : "";
        macro.body.erase(0, std::min(macro.body.find_first_not_of(" \t\r"), macro.body.size()));
        macro.body.erase(macro.body.find_last_not_of(" \t\r") + 1);
        macros_[name] = macro;
        return next;
    }

    /// A part of the text that is taken or left out.
    struct Condition {
        std::size_t place = 0;
        bool taken = false, was_taken = false, has_else = false;
    };
    bool is_left_out() const {
        return std::ranges::any_of(conditions_, [](const Condition& one) { return !one.taken; });
    }

    void condition(const std::string& kind, const std::string& rest, std::size_t at) {
        const bool opens = kind.starts_with("if");
        if (!opens && conditions_.empty()) fail(at, "#" + kind + " without #if");
        if (kind == "endif") return conditions_.pop_back();
        if (opens) {
            const bool outside = is_left_out();
            conditions_.push_back({at, false, outside, false});
            if (outside) return;
            std::string name(rest);
            std::erase_if(name, [](char c) { return !is_name_part(c); });
            conditions_.back().taken =
                kind == "if" ? holds(rest, at) : macros_.contains(name) == (kind == "ifdef");
        } else {
            Condition& here = conditions_.back();
            if (here.has_else) fail(at, "#" + kind + " behind #else");
            here.has_else = kind == "else";
            here.taken = !here.was_taken && (kind == "else" || holds(rest, at));
        }
        conditions_.back().was_taken = conditions_.back().was_taken || conditions_.back().taken;
    }

    /// Whether an expression of #if is other than 0.
    bool holds(const std::string& said, std::size_t at) {
        std::string text;
        for (std::size_t i = 0; i < said.size();) {
            if (!is_name_start(said[i])) {
                text += said[i++];
                continue;
            }
            std::size_t stop = i;
            while (stop < said.size() && is_name_part(said[stop])) ++stop;
            if (said.substr(i, stop - i) == "defined") {
                while (stop < said.size() && !is_name_start(said[stop])) ++stop;
                std::size_t end = stop;
                while (end < said.size() && is_name_part(said[end])) ++end;
                text += macros_.contains(said.substr(stop, end - stop)) ? "1" : "0";
                while (end < said.size() && said[end] == ')') ++end;
                i = end;
                continue;
            }
            Placed value;
            i = expand(said, i, at, value, 1);
            text += value.text;
        }
        Placed placed;
        for (const char c : text)
            if (!std::isspace(static_cast<unsigned char>(c)) || c == ' ') placed.add(c, at);
        const std::string expression =
            cpfg_expression(source_, dialect_, placed.trimmed(), {}, CpfgNames{});
        const Quantity value =
            evaluate(read_expression(expression),
                     [](const std::string&) -> const Quantity* { return nullptr; });
        return value.value != 0;
    }

    /// Appends a name or what it stands for; gives where the text goes on.
    std::size_t expand(std::string_view text, std::size_t at, std::size_t place, Placed& out,
                       std::size_t depth) {
        constexpr std::size_t deepest = 50, longest = 1'000'000;
        std::size_t end = at;
        while (end < text.size() && is_name_part(text[end])) ++end;
        const std::string name(text.substr(at, end - at));
        const auto macro = macros_.find(name);
        if (depth > deepest || out.text.size() > longest)
            fail(place, "macros that go round in circles, or become too long");
        if (macro == macros_.end()) {
            for (std::size_t i = at; i < end; ++i) out.add(text[i], depth == 0 ? i : place);
            return end;
        }
        std::vector<std::string> values;
        if (macro->second.takes) {
            std::size_t i = end;
            while (i < text.size() && text[i] == ' ') ++i;
            if (i >= text.size() || text[i] != '(') {
                for (std::size_t k = at; k < end; ++k) out.add(text[k], depth == 0 ? k : place);
                return end;
            }
            std::size_t open = 0;
            std::string value;
            for (; i < text.size(); ++i) {
                const char c = text[i];
                if (c == '(' && open++ == 0) continue;
                if (c == ')' && --open == 0) break;
                if (c == ',' && open == 1) {
                    values.push_back(value);
                    value.clear();
                } else {
                    value += c;
                }
            }
            values.push_back(value);
            if (values.size() != macro->second.parameters.size())
                fail(place, "the macro " + name + " has " +
                                std::to_string(macro->second.parameters.size()) +
                                " parameters, found " + std::to_string(values.size()));
            end = std::min(i + 1, text.size());
        }
        std::string body;
        const std::string& written = macro->second.body;
        for (std::size_t i = 0; i < written.size();) {
            if (!is_name_start(written[i])) {
                body += written[i++];
                continue;
            }
            std::size_t stop = i;
            while (stop < written.size() && is_name_part(written[stop])) ++stop;
            const std::string part = written.substr(i, stop - i);
            const auto parameter = std::ranges::find(macro->second.parameters, part);
            body += parameter == macro->second.parameters.end()
                        ? part
                        : values[static_cast<std::size_t>(parameter -
                                                          macro->second.parameters.begin())];
            i = stop;
        }
        for (std::size_t i = 0; i < body.size();) {
            if (is_name_start(body[i]) && (i == 0 || !is_name_part(body[i - 1]))) {
                i = expand(body, i, place, out, depth + 1);
                continue;
            }
            out.add(body[i++], place);
        }
        return end;
    }

    [[noreturn]] void fail(std::size_t place, const std::string& message) const {
        cpfg_fail(source_, place, message);
    }
    [[noreturn]] void refuse(std::size_t place, const std::string& what,
                             const std::string& why) const {
        cpfg_refuse(source_, place, what, why);
    }

    const Source& source_;
    std::string_view text_;
    const CpfgDialect& dialect_;
    std::map<std::string, Macro> macros_;
    std::vector<Condition> conditions_;
};

struct Expressions {
    const Source& source;
    const CpfgDialect& dialect;
    const CpfgNames& known_names;
    const Placed& text;
    const std::set<std::string>& names;
    const CpfgIntegers& integers;
    std::size_t at = 0;
    bool integral = false;  // in C, what was read last is a whole number by its type

    std::string all() {
        std::string found = whole();
        blanks();
        if (at < text.text.size()) unexpected();
        if (integers.wanted && !integral) found = whole_part(found);
        return found;
    }
    [[noreturn]] void unexpected() const {
        const std::string found =
            at < text.text.size() ? "'" + text.text.substr(at, 1) + "'" : "its end";
        std::string hint;
        if (at < text.text.size() && text.text[at] == '=') hint = "; a comparison is ==";
        if (at < text.text.size() && (text.text[at] == '&' || text.text[at] == '|'))
            hint = "; 'and' is && and 'or' is ||";
        cpfg_fail(source, text.place(at),
                  "expected an operator or the end of the expression, found " + found + hint);
    }
    void blanks() {
        while (at < text.text.size() &&
               (text.text[at] == ' ' || text.text[at] == '\t' ||
                (dialect.plus && (text.text[at] == '\n' || text.text[at] == '\r'))))
            ++at;
    }
    bool takes(std::string_view sign) {
        blanks();
        if (!std::string_view(text.text).substr(at).starts_with(sign)) return false;
        at += sign.size();
        return true;
    }
    bool python() const { return dialect.python; }

    /// A binary operator: how the program writes it, and how the notation says it of its two sides.
    struct Operator {
        std::string_view sign;
        const char* said;  // `%` is made of others
    };
    using Levels = std::vector<std::vector<Operator>>;

    /// From the loosest to the tightest, all of them grouped from the left.
    const Levels& levels() const {
        static const Levels cpfg{{{"||", "|"}},
                                 {{"&&", "&"}},
                                 {{"==", "="}, {"!=", "!="}, {"<>", "!="}},
                                 {{"<=", "<="}, {">=", ">="}, {"<", "<"}, {">", ">"}},
                                 {{"+", "+"}, {"-", "-"}},
                                 {{"*", "*"}, {"/", "/"}, {"%", "%"}}};
        static const Levels python{
            {{"or ", "|"}},
            {{"and ", "&"}},
            {{"==", "="}, {"!=", "!="}, {"<=", "<="}, {">=", ">="}, {"<", "<"}, {">", ">"}},
            {{"+", "+"}, {"-", "-"}},
            {{"*", "*"}, {"/", "/"}, {"%", "%"}}};
        return dialect.python ? python : cpfg;
    }

    /// The next operator, if it is one of this level; those of others that begin alike are left.
    const Operator* taken(const std::vector<Operator>& level) {
        blanks();
        const std::string_view rest = std::string_view(text.text).substr(at);
        for (const char* longer : {"**", "//"})
            if (python() && rest.starts_with(longer)) {
                if (rest[0] == '/')
                    cpfg_refuse(source, text.place(at), "//",
                                "in an expression has no meaning in the notation");
                return nullptr;
            }
        for (const Operator& one : level)
            if (takes(one.sign)) {
                if (one.sign == "<" && rest.starts_with("<>")) {
                    --at;
                    continue;
                }
                return &one;
            }
        return nullptr;
    }

    std::string binary(std::size_t level) {
        if (level == levels().size()) return python() ? signed_power() : power();
        std::string left = binary(level + 1);
        bool compared = false;
        while (const Operator* one = taken(levels()[level])) {
            const std::size_t sign = at;
            const bool left_integral = integral;
            const std::string right = binary(level + 1);
            const bool both = left_integral && integral;
            integral = both || level < 4;  // relations are 0 or 1
            const bool compares = python() && level == 2;
            if (compares && compared)
                cpfg_refuse(source, text.place(sign), "a chain of comparisons",
                            "is not read: say `a < b and b < c`");
            compared = compares;
            if (dialect.plus && both && one->sign == "/") {
                check_size(left + right);
                left = whole_part("(" + left + "/" + right + ")");
            } else if (one->sign != "%")
                left = "(" + left + " " + one->said + " " + right + ")";
            else if (python())
                left = "(" + left + " - " + right + "*floor(" + left + "/" + right + "))";
            else
                left = remainder(left, right);
        }
        return left;
    }

    /// The whole part, towards 0, of an expression.
    static std::string whole_part(const std::string& x) {
        return x.find_first_not_of("0123456789") == std::string::npos
                   ? x
                   : "(floor(abs(" + x + "))*((" + x + " >= 0) - (" + x + " < 0)))";
    }
    /// What is left of whole parts; its sign is that of the left side, as in C.
    std::string remainder(const std::string& left, const std::string& right) const {
        const std::string x = whole_part(left), y = whole_part(right);
        check_size(x);
        return "(" + x + " - " + y + "*" + whole_part("(" + x + "/" + y + ")") + ")";
    }
    /// Parts of expressions are repeated where the notation has no word for what is done with them.
    void check_size(const std::string& said) const {
        constexpr std::size_t longest = 10'000;
        if (said.size() > longest)
            cpfg_refuse(source, text.place(at), "an expression",
                        "would be too long in the notation: it nests %, ?: or trunc too deep");
    }

    /// With `?:`, which the notation says by numbers that are 1 where a relation holds and 0 where it does not.
    std::string whole() {
        const std::string condition = binary(0);
        check_size(condition);
        if (python() || !takes("?")) return condition;
        const std::string yes = whole();
        const bool yes_integral = integral;
        if (!takes(":")) unexpected();
        const std::string no = whole();
        integral = integral && yes_integral;
        return "((" + condition + " != 0)*" + yes + " + (" + condition + " = 0)*" + no + ")";
    }

    /// Of cpfg: from the left, and a sign binds tighter.
    std::string power() {
        std::string left = signed_atom();
        blanks();
        if (dialect.plus && at < text.text.size() && text.text[at] == '^')
            cpfg_refuse(source, text.place(at), "^", "is exclusive or in C: a power is pow(x,y)");
        while (takes("^")) left = "((" + left + ")^(" + signed_atom() + "))";
        return left;
    }
    std::string signed_atom() {
        if (takes("-")) return "(-" + signed_atom() + ")";
        blanks();
        if (at + 1 < text.text.size() && text.text[at] == '!' && text.text[at + 1] != '=') {
            ++at;
            const std::string said = signed_atom();
            integral = true;
            return "(!(" + said + "))";
        }
        if (takes("&")) unexpected();
        return atom();
    }
    /// Of Python: from the right, and a sign is looser.
    std::string signed_power() {
        if (takes("-")) return "(-" + signed_power() + ")";
        if (takes("not ")) return "(!(" + signed_power() + "))";
        const std::string base = atom();
        if (!takes("**")) {
            blanks();
            if (at < text.text.size() && text.text[at] == '^')
                cpfg_refuse(source, text.place(at), "^",
                            "is exclusive or in Python: a power is **");
            return base;
        }
        return "((" + base + ")^(" + signed_power() + "))";
    }
    std::string atom() {
        blanks();
        const std::size_t begin = at;
        if (takes("(")) {
            const std::string inside = whole();
            if (!takes(")")) unexpected();
            return "(" + inside + ")";
        }
        if (at < text.text.size() &&
            (std::isdigit(static_cast<unsigned char>(text.text[at])) || text.text[at] == '.'))
            return number();
        std::string called;
        while (at < text.text.size() && is_name_part(text.text[at])) called += text.text[at++];
        if (python() && called == "math" && takes(".")) {
            called.clear();
            while (at < text.text.size() && is_name_part(text.text[at])) called += text.text[at++];
        }
        if (called.empty()) unexpected();
        if (!takes("(")) {
            integral = integers.names.contains(called);
            if (names.contains(called)) return called;
            const auto known = known_names.find(called);
            if (known == known_names.end() && (python() || dialect.plus))
                cpfg_fail(source, text.place(begin), "the name '" + called + "' has no value");
            if (known == known_names.end()) return "0";  // with a warning there
            if (known->second.empty())
                cpfg_refuse(source, text.place(begin), called,
                            "is the number of the step, which has no meaning in the notation");
            return known->second;
        }
        std::vector<std::string> arguments{whole()};
        while (takes(",")) arguments.push_back(whole());
        if (!takes(")")) unexpected();
        const bool was_integral = integral;
        integral = called == "int" || (called == "abs" && was_integral && arguments.size() == 1);
        if (called == "int" && was_integral && arguments.size() == 1) return arguments[0];
        return call(called, arguments, begin);
    }
    std::string call(const std::string& called, const std::vector<std::string>& arguments,
                     std::size_t begin) const {
        static const std::map<std::string, std::string> functions{
            {"sin", "sin"},   {"cos", "cos"},   {"tan", "tan"}, {"asin", "asin"},
            {"acos", "acos"}, {"atan", "atan"}, {"exp", "exp"}, {"log", "log"},
            {"sqrt", "sqrt"}, {"fabs", "abs"},  {"abs", "abs"}, {"floor", "floor"},
            {"ceil", "ceil"}, {"min", "min"},   {"max", "max"}};
        const auto known = functions.find(called);
        const bool trigonometric =
            called.ends_with("sin") || called.ends_with("cos") || called.ends_with("tan");
        if ((python() || dialect.plus) && trigonometric)
            cpfg_refuse(source, text.place(begin), "the function " + called,
                        python() ? "takes radians in Python, degrees in the notation"
                                 : "takes radians in C, degrees in the notation");
        if (known != functions.end()) return known->second + "(" + joined(arguments, ",") + ")";
        const auto takes_count = [&](std::size_t count) {
            if (arguments.size() != count)
                cpfg_fail(source, text.place(begin),
                          called + " takes " + std::to_string(count) + " numbers, found " +
                              std::to_string(arguments.size()));
            for (const std::string& one : arguments) check_size(one);
        };
        const std::string& x = arguments[0];
        if (dialect.plus && (called == "int" || called == "trunc")) {
            takes_count(1);
            return whole_part(x);
        }
        if (dialect.plus && (called == "float" || called == "double")) {
            takes_count(1);
            return x;
        }
        if (dialect.plus && called == "pow") {
            takes_count(2);
            return "((" + x + ")^(" + arguments[1] + "))";
        }
        if (dialect.plus)
            cpfg_refuse(source, text.place(begin), "the function " + called,
                        "has no meaning in the notation");
        if (!python() && called == "trunc") {
            takes_count(1);
            return "floor(" + x + " + 1/2)";
        }
        if (!python() && called == "sign") {
            takes_count(1);
            return "((" + x + " > 0) - (" + x + " < 0))";
        }
        if (!python() && called == "atan2") {
            takes_count(2);
            return "(((" + x + " >= 0) - (" + x + " < 0))*acos(" + arguments[1] + "/sqrt((" + x +
                   ")^2 + (" + arguments[1] + ")^2)))";
        }
        cpfg_refuse(source, text.place(begin), "the function " + called,
                    "has no meaning in the notation");
    }
    std::string number() {
        const std::size_t size = number_size(std::string_view(text.text).substr(at));
        std::string digits = text.text.substr(at, size);
        integral = digits.find_first_of(".eE") == std::string::npos;
        if (!python() && !dialect.plus && digits.find_first_of("eE") != std::string::npos &&
            digits.find('.') == std::string::npos)
            cpfg_fail(source, text.place(at),
                      "the exponent of a number needs a decimal point: 1.0e5");
        at += size;
        digits = plain_number(digits);
        if (digits.starts_with('.')) digits = "0" + digits;
        if (digits.find_first_of("eE") == std::string::npos) return digits;
        const auto exact = exact_decimal(Rational(digits));
        return exact ? *exact : digits;
    }
};

}  // namespace

Placed preprocessed(const Source& source, const CpfgDialect& dialect) {
    return Preprocessor(source, dialect).preprocessed();
}

std::string cpfg_expression(const Source& source, const CpfgDialect& dialect, const Placed& text,
                            const std::set<std::string>& names, const CpfgNames& known,
                            const CpfgIntegers& integers) {
    return Expressions{source, dialect, known, text, names, integers}.all();
}

}  // namespace algae
