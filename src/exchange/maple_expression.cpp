#include "exchange/maple_expression.hpp"

#include <algorithm>
#include <cctype>

#include "exchange/made_expression.hpp"
#include "exchange/maple_functions.hpp"
#include "notation/characters.hpp"

namespace algae {

namespace {

constexpr std::size_t most_depth = 100, most_operations = 150, longest_number = 1000;

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
                left.name == "*" && left.operands[1] == number_expression(180))
                left = scaled(Expression(left.operands[0]), number_expression(180), pi());
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
        return made_expression(Expression::Kind::unary, "-", {signed_power()});
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
            exponent = made_expression(Expression::Kind::unary, "-", {atom()});
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
        return made_expression(Expression::Kind::name, name, {});
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
        return number_expression(value);
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

}  // namespace algae
