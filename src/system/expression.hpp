#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/place.hpp"
#include "exact/rational.hpp"

namespace algae {

/// An arithmetic or logical expression over named parameters and constants, as written.
///
/// Operators, loosest first: `|`, `&`, relations (`< <= > >= = !=`), `+ -`, `* /`, unary `- !`,
/// `^` (right associative, binds tighter than unary minus: -2^2 = -4). Truth is 1, falsehood 0.
/// Functions: sin cos tan asin acos atan (degrees), sqrt exp log abs floor ceil min max.
struct Expression {
    enum class Kind { number, name, unary, binary, call };

    Kind kind = Kind::number;
    Rational value;                    // of a number
    std::string name;                  // the name, the operator or the function
    std::vector<Expression> operands;  // one or two of an operator, the arguments of a call
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

/// The quantity of a plain rational.
Quantity quantity(const Rational& value);

/// The expression with as few brackets as it needs, blanks only around logical and relational
/// operators: "x+y", "(x+y)/2", "x <= 3 & y > 0". Read back, it is the same expression.
///
/// Example: to_text(parsed("((x+y)/2)")) == "(x+y)/2"
std::string to_text(const Expression& expression);

}  // namespace algae
