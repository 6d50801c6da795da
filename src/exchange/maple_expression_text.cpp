#include <algorithm>
#include <iterator>

#include "base/error.hpp"
#include "exchange/maple_expression.hpp"
#include "exchange/maple_functions.hpp"
#include "notation/characters.hpp"

namespace algae {

namespace {

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
            std::find_if(std::begin(maple_functions), std::end(maple_functions),
                         [&](const MapleFunction& one) { return expression.name == one.name; });
        if (function == std::end(maple_functions)) fail(expression);
        std::string arguments;
        const bool angle = function->angle == MapleFunction::Angle::argument;
        for (const Expression& one : expression.operands)
            arguments += (arguments.empty() ? "" : ",") + text(one, angle ? product : sign);
        const std::string call = function->maple + ("(" + arguments);
        if (angle) return {call + "*Pi/180)", atom};
        if (function->angle == MapleFunction::Angle::value) return {call + ")*180/Pi", product};
        return {call + ")", atom};
    }

    const std::function<std::string(const std::string&)>& name_text_;
};

}  // namespace

std::string maple_text(const Expression& expression,
                       const std::function<std::string(const std::string&)>& name_text) {
    return Printer(name_text).text(expression, Printer::sign);
}

}  // namespace algae
