#include "exchange/netlogo_number.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "base/error.hpp"
#include "exchange/made_expression.hpp"

namespace algae {

namespace {

/// NetLogo's reporters of one number, by what the notation calls them.
const std::map<std::string, std::string>& reporters() {
    static const std::map<std::string, std::string> all{
        {"abs", "abs"}, {"cos", "cos"},   {"exp", "exp"}, {"log", "ln"},
        {"sin", "sin"}, {"sqrt", "sqrt"}, {"tan", "tan"}};
    return all;
}

bool is_digit_of(std::string_view text, std::size_t at) {
    return at < text.size() && text[at] >= '0' && text[at] <= '9';
}

/// The bytes of the number that the text begins with; 0 if it begins with none.
std::size_t number_size(std::string_view text) {
    std::size_t size = text.starts_with('-') ? 1 : 0;
    const auto digits = [&] {
        const std::size_t before = size;
        while (is_digit_of(text, size)) ++size;
        return size > before;
    };
    bool any = digits();
    if (size < text.size() && text[size] == '.') {
        ++size;
        any = digits() || any;
    }
    if (!any) return 0;
    const std::size_t mantissa = size;
    if (size < text.size() && (text[size] == 'e' || text[size] == 'E')) {
        ++size;
        if (size < text.size() && (text[size] == '-' || text[size] == '+')) ++size;
        if (!digits()) size = mantissa;
    }
    return size;
}

class Reader {
public:
    explicit Reader(Scanner& scanner) : scanner_(scanner) {}

    Expression sum(std::size_t depth) {
        Expression left = product(depth);
        while (const char sign = infix("+-")) left = binary(sign, std::move(left), product(depth));
        return left;
    }

private:
    Expression product(std::size_t depth) {
        Expression left = power(depth);
        while (const char sign = infix("*/")) left = binary(sign, std::move(left), power(depth));
        return left;
    }
    Expression power(std::size_t depth) {
        Expression left = atom(depth);
        while (const char sign = infix("^")) left = binary(sign, std::move(left), atom(depth));
        return left;
    }
    Expression atom(std::size_t depth) {
        constexpr std::size_t most = 100;
        if (depth == most)
            scanner_.fail_at(scanner_.offset(), "more than 100 brackets inside each other");
        if (const std::size_t size = number_size(scanner_.rest())) {
            const std::string text(scanner_.rest().substr(0, size));
            // A point without digits behind it is none of the notation.
            const std::size_t point = text.find('.');
            std::string exact = text;
            if (point != std::string::npos && !is_digit_of(text, point + 1)) exact.erase(point, 1);
            const std::size_t at = scanner_.offset();
            scanner_.take(text);
            try {
                return quantity(Rational(exact)).expression;
            } catch (const Diagnostics&) {
                throw;
            } catch (const Error& error) {
                scanner_.fail_at(at, error.what());
            }
        }
        if (scanner_.take("(")) {
            const bool minus = infix("-") != 0;
            Expression inner = minus ? atom(depth + 1) : sum(depth + 1);
            scanner_.expect(")", "or an operator between blanks");
            if (!minus) return inner;
            count();
            return made_expression(Expression::Kind::unary, "-", {std::move(inner)});
        }
        for (const auto& [name, reporter] : reporters())
            if (scanner_.take_word(reporter)) {
                count();
                return made_expression(Expression::Kind::call, name, {atom(depth + 1)});
            }
        scanner_.fail("a number");
    }

    /// The operator that comes next, with a blank behind it; 0 if none does.
    char infix(std::string_view signs) {
        const std::string_view rest = scanner_.rest();
        if (rest.size() < 2 || signs.find(rest[0]) == std::string_view::npos ||
            !std::isspace(static_cast<unsigned char>(rest[1])))
            return 0;
        count();
        const char sign = rest[0];
        scanner_.take(std::string_view(&sign, 1));
        return sign;
    }
    void count() {
        constexpr std::size_t most = 100;
        if (++operators_ > most)
            scanner_.fail_at(scanner_.offset(), "more than 100 operators in a number");
    }
    static Expression binary(char sign, Expression left, Expression right) {
        return made_expression(Expression::Kind::binary, std::string(1, sign),
                               {std::move(left), std::move(right)});
    }

    Scanner& scanner_;
    std::size_t operators_ = 0;
};

std::string decimal_of(double value) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

std::string value_of(const Quantity& number) {
    if (!number.exact) return decimal_of(number.value);
    if (const auto text = exact_decimal(*number.exact); text && text->size() < 40) return *text;
    return decimal_of(number.value);
}

/// The expression in NetLogo, in brackets where `inner` says so; empty where it knows something else.
std::string written(const Expression& expression, bool inner) {
    std::string out;
    switch (expression.kind) {
        case Expression::Kind::number: {
            const auto text = exact_decimal(expression.value);
            return text && text->size() < 40 ? *text : "";
        }
        case Expression::Kind::unary: {
            if (expression.name != "-") return "";
            const std::string of = written(expression.operands[0], true);
            if (of.empty()) return "";
            return std::isdigit(static_cast<unsigned char>(of[0])) ? '-' + of : "(- " + of + ')';
        }
        case Expression::Kind::binary: {
            const std::string left = written(expression.operands[0], true);
            const std::string right = written(expression.operands[1], true);
            if (std::string("+-*/^").find(expression.name) == std::string::npos || left.empty() ||
                right.empty())
                return "";
            out = left + ' ' + expression.name + ' ' + right;
            return inner ? '(' + out + ')' : out;
        }
        case Expression::Kind::call: {
            const auto reporter = reporters().find(expression.name);
            if (reporter == reporters().end() || expression.operands.size() != 1) return "";
            const auto& operand = expression.operands[0];
            const std::string of = written(operand, true);
            const bool nests = operand.kind == Expression::Kind::call;
            if (of.empty()) return "";
            return reporter->second + ' ' + (nests ? '(' + of + ')' : of);
        }
        default:
            return "";
    }
}

}  // namespace

Quantity read_netlogo_number(Scanner& scanner) {
    const std::size_t at = scanner.offset();
    const Expression expression = Reader(scanner).sum(0);
    Quantity number;
    try {
        number = evaluate(expression, {});
    } catch (const Diagnostics& error) {
        scanner.fail_at(at, error.findings().front().message);
    }
    constexpr double most = 1e9;
    if (!(std::fabs(number.value) <= most))
        scanner.fail_at(at, "expected a number from -10^9 to 10^9");
    return number;
}

std::string netlogo_number(const Quantity& number) {
    const std::string text = written(number.expression, false);
    return text.empty() ? value_of(number) : text;
}

Quantity negated(const Quantity& number) {
    if (number.exact) return quantity(-*number.exact);
    const Expression& expression = number.expression;
    const bool minus = expression.kind == Expression::Kind::unary && expression.name == "-";
    return {minus ? expression.operands[0]
                  : made_expression(Expression::Kind::unary, "-", {expression}),
            std::nullopt, -number.value};
}

Quantity turned_compass(const Quantity& degrees) {
    const Quantity ninety = quantity(90);
    if (degrees.exact) return quantity(*ninety.exact - *degrees.exact);
    const Expression& expression = degrees.expression;
    const bool turned = expression.kind == Expression::Kind::binary && expression.name == "-" &&
                        expression.operands[0] == ninety.expression;
    return {turned
                ? expression.operands[1]
                : made_expression(Expression::Kind::binary, "-", {ninety.expression, expression}),
            std::nullopt, 90 - degrees.value};
}

}  // namespace algae
