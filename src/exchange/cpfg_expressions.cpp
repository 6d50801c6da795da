#include <cctype>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "exchange/detail/cpfg.hpp"
#include "exchange/detail/scanner.hpp"

// Expressions of cpfg, L-Py and lpfg: one grammar with a table of operators for Python and one for the others.
//
// In expressions of cpfg `^` groups from the left and a sign binds tighter than it; in Python a power groups from the right and binds tighter
// than a sign; in L+C whole numbers are divided as in C, by their types. Each operator is written with brackets, so the notation groups it the same.

namespace algae {

namespace {

struct Expressions {
    const Source& source;
    const CpfgDialect& dialect;
    const CpfgNames& known_names;
    const Placed& text;
    const std::set<std::string>& names;
    const CpfgIntegers& integers;
    std::size_t at = 0;
    bool integral = false;  // in C, what was read last is a whole number by its type
    bool is_truth = false;  // what was read last is 1 or 0, by a comparison

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
            const bool left_integral = integral, left_is_truth = is_truth;
            const std::string right = binary(level + 1);
            is_truth = level <= 2 && (level == 2 || (left_is_truth && is_truth));
            const bool both = left_integral && integral;
            integral = both || level < 4;  // relations are 0 or 1
            const bool compares = python() && level == 2;
            if (compares && compared)
                cpfg_refuse(source, text.place(sign), "a chain of comparisons",
                            "is not read: say `a < b and b < c`");
            compared = compares;
            if (python() && level < 2 &&
                !is_truth) {  // one of the two sides, and not whether it holds
                check_size(left + right);
                left = level == 1 ? "((" + left + " != 0)*" + right + ")"
                                  : "(" + left + " + (" + left + " = 0)*" + right + ")";
            } else if (dialect.plus && both && one->sign == "/") {
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
        if (takes("-")) {
            const std::string said = "(-" + signed_power() + ")";
            is_truth = false;
            return said;
        }
        if (takes("not ")) {
            const std::string said = "(!(" + signed_power() + "))";
            is_truth = true;
            return said;
        }
        const std::string base = atom();
        if (!takes("**")) {
            blanks();
            if (at < text.text.size() && text.text[at] == '^')
                cpfg_refuse(source, text.place(at), "^",
                            "is exclusive or in Python: a power is **");
            return base;
        }
        const std::string said = "((" + base + ")^(" + signed_power() + "))";
        is_truth = false;
        return said;
    }
    std::string atom() {
        blanks();
        is_truth = false;
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
                            "is assigned by a block, and keeps its value from one rule to the "
                            "next, which has no meaning in the notation");
            return known->second;
        }
        std::vector<std::string> arguments{whole()};
        while (takes(",")) arguments.push_back(whole());
        if (!takes(")")) unexpected();
        is_truth = false;
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
        if ((python() || dialect.plus) && integral && digits.size() > 1 && digits[0] == '0')
            cpfg_fail(source, text.place(at),
                      python()
                          ? "a number begins with 0, which Python refuses: say it without the 0"
                          : "a number that begins with 0 is octal in C: say it without the 0");
        at += size;
        digits = plain_number(digits);
        if (digits.starts_with('.')) digits = "0" + digits;
        if (digits.find_first_of("eE") == std::string::npos) return digits;
        const auto exact = exact_decimal(Rational(digits));
        return exact ? *exact : digits;
    }
};

}  // namespace

std::string cpfg_expression(const Source& source, const CpfgDialect& dialect, const Placed& text,
                            const std::set<std::string>& names, const CpfgNames& known,
                            const CpfgIntegers& integers) {
    return Expressions{source, dialect, known, text, names, integers}.all();
}

}  // namespace algae
