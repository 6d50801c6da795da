#include "exchange/maple_expression.hpp"

#include <algorithm>
#include <cctype>

#include "notation/characters.hpp"

namespace algae {

namespace {

constexpr std::size_t most_depth = 100, most_operations = 150, longest_number = 1000;

/// What Maple calls a function of the notation. Angles are degrees here and radians there.
struct Function {
    const char *name, *maple;
    enum class Angle { none, argument, value } angle = Angle::none;
};
constexpr Function functions[] = {{"sqrt", "sqrt"},
                                  {"exp", "exp"},
                                  {"log", "ln"},
                                  {"log", "log"},
                                  {"abs", "abs"},
                                  {"floor", "floor"},
                                  {"ceil", "ceil"},
                                  {"min", "min"},
                                  {"max", "max"},
                                  {"sin", "sin", Function::Angle::argument},
                                  {"cos", "cos", Function::Angle::argument},
                                  {"tan", "tan", Function::Angle::argument},
                                  {"asin", "arcsin", Function::Angle::value},
                                  {"acos", "arccos", Function::Angle::value},
                                  {"atan", "arctan", Function::Angle::value}};

Expression number(const Rational& value) {
    Expression made;
    made.value = value;
    return made;
}

Expression made(Expression::Kind kind, const std::string& name, std::vector<Expression> operands) {
    Expression out;
    out.kind = kind;
    out.name = name;
    out.operands = std::move(operands);
    return out;
}

Expression binary(const std::string& name, Expression left, Expression right) {
    return made(Expression::Kind::binary, name, {std::move(left), std::move(right)});
}

const Expression& pi() {
    static const Expression value =
        number(Rational("3.14159265358979323846264338327950288419716939937511"));
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

class Reader {
public:
    Reader(Scanner& scanner, const std::string& parameters)
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
            scanner_.fail_at(offset, "an expression with more than " +
                                         std::to_string(most_operations) + " operators and calls");
    }

    Expression sum() {
        if (++depth_ > most_depth)
            scanner_.fail_at(scanner_.offset(), "an expression nested more than " +
                                                    std::to_string(most_depth) + " deep");
        Expression left = product();
        for (;;) {
            const std::size_t where = scanner_.offset();
            const bool plus = scanner_.take("+");
            if (!plus && !scanner_.take("-")) break;
            count(where);
            left = binary(plus ? "+" : "-", std::move(left), product());
        }
        --depth_;
        return left;
    }

    Expression product() {
        Expression left = signed_power();
        for (;;) {
            const std::size_t where = scanner_.offset();
            const bool times = scanner_.take("*");
            if (!times && !scanner_.take("/")) return left;
            count(where);
            Expression right = signed_power();
            if (!times && right == pi() && left.kind == Expression::Kind::binary &&
                left.name == "*" && left.operands[1] == number(180))
                left = scaled(Expression(left.operands[0]), number(180), pi());
            else
                left = binary(times ? "*" : "/", std::move(left), std::move(right));
        }
    }

    Expression signed_power() {
        const std::size_t where = scanner_.offset();
        if (scanner_.take("+")) {
            count(where);
            return signed_power();
        }
        if (!scanner_.take("-")) return power();
        count(where);
        return made(Expression::Kind::unary, "-", {signed_power()});
    }

    Expression power() {
        Expression base = atom();
        const std::size_t where = scanner_.offset();
        if (!scanner_.take("^") && !scanner_.take("**")) return base;
        count(where);
        const std::size_t minus = scanner_.offset();
        Expression exponent;
        if (scanner_.take("-")) {
            count(minus);
            exponent = made(Expression::Kind::unary, "-", {atom()});
        } else {
            exponent = atom();
        }
        if (scanner_.rest().starts_with("^") || scanner_.rest().starts_with("**"))
            scanner_.fail("brackets that say which power is taken first");
        return binary("^", std::move(base), std::move(exponent));
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
            scanner_.fail_at(where, parameters_.empty()
                                        ? "expected a number, found an entry of " + quoted(name)
                                        : "expected an entry of " + quoted(parameters_) +
                                              ", found one of " + quoted(name));
        read_.names.emplace_back(name, where);
        return made(Expression::Kind::name, name, {});
    }

    Expression literal() {
        const std::string_view rest = scanner_.rest();
        const auto digits = [&](std::size_t from) {
            while (from < rest.size() && std::isdigit(static_cast<unsigned char>(rest[from])))
                ++from;
            return from;
        };
        std::size_t size = digits(0);
        std::string text(rest.substr(0, size));
        if (rest.substr(size).starts_with('.')) {
            const std::size_t end = digits(size + 1);
            if (end == 1) scanner_.fail("a number");
            if (end > size + 1) text += rest.substr(size, end - size);
            size = end;
        }
        if (size < rest.size() && (rest[size] == 'e' || rest[size] == 'E')) {
            const bool sign =
                size + 1 < rest.size() && (rest[size + 1] == '-' || rest[size + 1] == '+');
            const std::size_t first = size + (sign ? 2 : 1), end = digits(first);
            if (end > first) {
                text += rest.substr(size, end - size);
                size = end;
            }
        }
        Rational value;
        try {
            if (text.size() > longest_number) throw Error("");
            value = Rational(text);
        } catch (const Error&) {
            scanner_.fail_at(scanner_.offset(), "the number " + quoted(text) + " is out of range");
        }
        scanner_.take(rest.substr(0, size));
        return number(value);
    }

    Expression parameter() {
        scanner_.take(parameters_);
        scanner_.expect("[", "behind the list " + parameters_);
        const std::size_t where = scanner_.offset();
        const Rational index = scanner_.number("the number of a parameter", 1, 1000);
        if (!index.is_integer())
            scanner_.fail_at(where, "expected a whole number, found " + to_string(index));
        scanner_.expect("]", "");
        const std::string text = to_string(index);
        read_.most_index = std::max(read_.most_index, std::stoul(text));
        return made(Expression::Kind::name, parameters_ + "[" + text + "]", {});
    }

    Expression call(const std::string& name, std::size_t where) {
        count(where);
        const auto* function = std::find_if(std::begin(functions), std::end(functions),
                                            [&](const Function& one) { return name == one.maple; });
        if (function == std::end(functions) && name != "evalf") {
            std::string known;
            for (const Function& one : functions) known += std::string(one.maple) + ", ";
            scanner_.fail_at(
                where, "expected one of " + known + "evalf, found the function " + quoted(name));
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
        if (function->angle == Function::Angle::argument)
            arguments[0] = scaled(std::move(arguments[0]), number(180), pi());
        Expression value = made(Expression::Kind::call, function->name, std::move(arguments));
        if (function->angle == Function::Angle::value)
            return scaled(std::move(value), pi(), number(180));
        return value;
    }

    Scanner& scanner_;
    const std::string& parameters_;
    MapleExpression read_;
    std::size_t depth_ = 0, operations_ = 0;
};

/// Prints with the brackets that Maple asks for: none may stand before a sign or between powers.
class Printer {
public:
    explicit Printer(const std::function<std::string(const std::string&)>& name_text)
        : name_text_(name_text) {}

    enum Binding { sign, sum, product, atom };

    std::string text(const Expression& expression, Binding least) const {
        const auto [bare, binding] = bare_text(expression);
        return binding < least ? "(" + bare + ")" : bare;
    }

private:
    using Bare = std::pair<std::string, Binding>;

    [[noreturn]] static void fail(const Expression& expression) {
        throw Error(quoted(to_text(expression)) + " in arithmetic");
    }

    Bare bare_text(const Expression& expression) const {
        switch (expression.kind) {
            case Expression::Kind::number: {
                const std::string text = shortest_text(expression.value);
                return {text, text.starts_with('-')             ? sign
                              : exact_decimal(expression.value) ? atom
                                                                : product};
            }
            case Expression::Kind::name:
                return {name_text_(expression.name), atom};
            case Expression::Kind::unary:
                if (expression.name != "-") break;
                return {"-" + text(expression.operands[0], atom), sign};
            case Expression::Kind::binary:
                return binary_text(expression);
            case Expression::Kind::call:
                return call_text(expression);
            case Expression::Kind::word:
                break;
        }
        fail(expression);
    }

    Bare binary_text(const Expression& expression) const {
        const std::string& name = expression.name;
        const bool adds = name == "+" || name == "-", multiplies = name == "*" || name == "/";
        if (!adds && !multiplies && name != "^") fail(expression);
        const Binding own = adds ? sum : multiplies ? product : atom;
        const Binding tighter = adds ? product : atom;
        const std::string text = this->text(expression.operands[0], own) + name +
                                 this->text(expression.operands[1], tighter);
        // A power may be a factor and no base.
        return {text, name == "^" ? product : own};
    }

    Bare call_text(const Expression& expression) const {
        const auto* function =
            std::find_if(std::begin(functions), std::end(functions),
                         [&](const Function& one) { return expression.name == one.name; });
        if (function == std::end(functions)) fail(expression);
        std::string arguments;
        const bool angle = function->angle == Function::Angle::argument;
        for (const Expression& one : expression.operands)
            arguments += (arguments.empty() ? "" : ",") + text(one, angle ? product : sign);
        const std::string call = function->maple + ("(" + arguments);
        if (angle) return {call + "*Pi/180)", atom};
        if (function->angle == Function::Angle::value) return {call + ")*180/Pi", product};
        return {call + ")", atom};
    }

    const std::function<std::string(const std::string&)>& name_text_;
};

}  // namespace

std::string next_maple_name(Scanner& scanner) {
    const std::string_view rest = scanner.rest();
    std::size_t size = 0;
    while (size < rest.size() &&
           (std::isalpha(static_cast<unsigned char>(rest[size])) || rest[size] == '_' ||
            (size > 0 && std::isdigit(static_cast<unsigned char>(rest[size])))))
        ++size;
    return std::string(rest.substr(0, size));
}

MapleExpression read_maple_expression(Scanner& scanner, const std::string& parameters) {
    return Reader(scanner, parameters).all();
}

std::string maple_text(const Expression& expression,
                       const std::function<std::string(const std::string&)>& name_text) {
    return Printer(name_text).text(expression, Printer::sign);
}

}  // namespace algae
