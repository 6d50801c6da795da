#include "system/expression.hpp"

#include <algorithm>
#include <utility>

namespace algae {

namespace {

/// How tightly an operator binds; a number, a name or a call binds tightest.
enum Binding { loosest, disjunction, conjunction, relation, sum, product, prefix, power, tightest };

Binding binding(const Expression& expression) {
    switch (expression.kind) {
        case Expression::Kind::unary:
            return prefix;
        case Expression::Kind::binary:
            break;
        case Expression::Kind::number:
            if (sign(expression.value) < 0) return prefix;
            return exact_decimal(expression.value) ? tightest : product;
        default:
            return tightest;
    }
    const std::string& name = expression.name;
    if (name == "|") return disjunction;
    if (name == "&") return conjunction;
    if (name == "+" || name == "-") return sum;
    if (name == "*" || name == "/") return product;
    return name == "^" ? power : relation;
}

void print(const Expression& expression, Binding least, std::string& out);

void print_binary(const Expression& expression, std::string& out) {
    const Binding own = binding(expression);
    const auto tighter = static_cast<Binding>(own + 1);
    // A relation does not chain, ^ groups to the right and takes a sign there, all others group left.
    const Binding left = own == power || own == relation ? tighter : own;
    const Binding right = own == power ? prefix : tighter;
    print(expression.operands.at(0), left, out);
    out += own <= relation ? ' ' + expression.name + ' ' : expression.name;
    print(expression.operands.at(1), right, out);
}

void print(const Expression& expression, Binding least, std::string& out) {
    const bool brackets = binding(expression) < least;
    if (brackets) out += '(';
    switch (expression.kind) {
        case Expression::Kind::number:
            out += shortest_text(expression.value);
            break;
        case Expression::Kind::name:
            out += expression.name;
            break;
        case Expression::Kind::word:
            out += '"' + expression.name + '"';
            break;
        case Expression::Kind::unary:
            out += expression.name;
            print(expression.operands.at(0), prefix, out);
            break;
        case Expression::Kind::binary:
            print_binary(expression, out);
            break;
        case Expression::Kind::call:
            out += expression.name + '(';
            for (std::size_t i = 0; i < expression.operands.size(); ++i) {
                if (i > 0) out += ',';
                print(expression.operands[i], loosest, out);
            }
            out += ')';
            break;
    }
    if (brackets) out += ')';
}

Expression number(const Rational& value) {
    Expression out;
    out.value = value;
    return out;
}

Expression operation(Expression::Kind kind, std::string name, std::vector<Expression> operands) {
    Expression out;
    out.kind = kind;
    out.name = std::move(name);
    out.operands = std::move(operands);
    return out;
}

/// The expression that is read from the shortest text of a number.
Expression written(const Rational& value) {
    if (!exact_decimal(value))
        return operation(Expression::Kind::binary, "/",
                         {written(value.numerator()), number(value.denominator())});
    if (sign(value) < 0) return operation(Expression::Kind::unary, "-", {number(-value)});
    return number(value);
}

}  // namespace

std::string shortest_text(const Rational& value) {
    const auto decimal = exact_decimal(value);
    if (!decimal) return to_string(value);
    constexpr std::size_t readable = 21;  // shorter than this, an exponent only hinders
    if (decimal->size() <= readable) return *decimal;
    const std::string minus = decimal->front() == '-' ? "-" : "";
    std::string digits = decimal->substr(minus.size());
    long exponent = 0;
    if (const auto point = digits.find('.'); point != std::string::npos) {
        exponent = -static_cast<long>(digits.size() - point - 1);
        digits.erase(point, 1);
    }
    const auto first = digits.find_first_not_of('0');
    const auto last = digits.find_last_not_of('0');
    exponent += static_cast<long>(digits.size() - last - 1);
    std::string scientific =
        minus + digits.substr(first, last - first + 1) + 'e' + std::to_string(exponent);
    return scientific.size() < decimal->size() ? scientific : *decimal;
}

bool is_distance(const Expression& expression) {
    return expression.kind == Expression::Kind::call && expression.name == "distance";
}

bool reads_words(const Expression& expression) {
    if (expression.kind == Expression::Kind::word) return true;
    // What is called and is no function is a system.
    if (expression.kind == Expression::Kind::call &&
        (expression.name == "length" || !function_arity(expression.name)))
        return true;
    return std::any_of(expression.operands.begin(), expression.operands.end(), reads_words);
}

Quantity quantity(const Rational& value) { return {written(value), value, value.to_double()}; }

std::string to_text(const Expression& expression) {
    std::string out;
    print(expression, loosest, out);
    return out;
}

}  // namespace algae
