#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/place.hpp"
#include "exact/rational.hpp"

namespace algae {

struct ModuleWord;

/// An arithmetic or logical expression over named parameters and constants, as written.
///
/// Operators, loosest first: `|`, `&`, relations (`< <= > >= = !=`), `+ -`, `* /`, unary `- !`,
/// `^` (right associative, binds tighter than unary minus: -2^2 = -4). Truth is 1, falsehood 0.
/// Values are numbers and words: `"FF[+F]"`, and of a system NAME within the file `NAME(n)`, the
/// word of its generation n, a call. length(w) is the number of a word's modules; no other function or
/// operator takes words. Functions: sin cos tan asin acos atan (degrees), sqrt exp log abs floor ceil min max; of an axis
/// and a symbol, whose names are its operands, distance.
struct Expression {
    enum class Kind { number, name, unary, binary, call, word };

    Kind kind = Kind::number;
    Rational value;                    // of a number
    std::string name;                  // the name, the operator, the function or the word's text
    std::vector<Expression> operands;  // one or two of an operator, the arguments of a call
    std::shared_ptr<const ModuleWord> word = {};  // of a word; its text says it too
    Place place;                       // where it starts; not part of its identity

    bool operator==(const Expression& other) const {
        return kind == other.kind && value == other.value && name == other.name &&
               operands == other.operands;
    }
};

/// A number written as an expression: exact where it is made by + - * / and integral powers of
/// rationals, and a double in any case.
struct Quantity {
    Expression expression;
    std::optional<Rational> exact;
    double value = 0;

    bool operator==(const Quantity& other) const { return expression == other.expression; }
};

/// The quantity of a plain rational, written as a person would: 0.25, 1/3, -2.
Quantity quantity(const Rational& value);

/// Whether it is `distance(AXIS, SYMBOL)`.
bool is_distance(const Expression& expression);

/// Whether a word stands in it: one in quotes, one of a system, or a length.
bool reads_words(const Expression& expression);

/// What a name in an expression stands for; nullptr where it stands for nothing. A distance goes by
/// its text, `distance(X,wall)`.
using Names = std::function<const Quantity*(const std::string&)>;

/// The value of an expression: exact where all of it is made by + - * / ^, relations, logic, abs,
/// floor, ceil, min and max from exact values, or is a sine, cosine, tangent or square root that
/// happens to be rational. Throws `Diagnostics` with one finding, without its line, at the place of
/// the part that has no value: an unknown name, a division by 0, sqrt(-1), a number too large.
///
/// Example: evaluate(parsed("2^-3*6"), {}).exact == Rational(3, 4)
Quantity evaluate(const Expression& expression, const Names& names);

/// The number of arguments that a function takes: exactly `least`, or `least` and more; nothing if
/// there is no such function.
struct Arity {
    std::size_t least;
    bool or_more;
};
std::optional<Arity> function_arity(std::string_view name);

/// All functions, by name.
const std::vector<std::string>& function_names();

/// The shortest decimal that is exactly this, "0.25" or "1e300"; "1/3" where there is none.
///
/// Example: shortest_text(Rational(257, 10)) == "25.7"
std::string shortest_text(const Rational& value);

/// The expression with as few brackets as it needs, blanks only around logical and relational
/// operators: "x+y", "(x+y)/2", "x <= 3 & y > 0". Read back, it is the same expression.
///
/// Example: to_text(parsed("((x+y)/2)")) == "(x+y)/2"
std::string to_text(const Expression& expression);

}  // namespace algae
