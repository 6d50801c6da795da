#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "exchange/scanner.hpp"
#include "system/expression.hpp"

namespace algae {

/// An arithmetic expression of a Maple worksheet in the terms of the notation: sines and their like
/// take degrees, ln is log, Pi a number. Used within this room only.
struct MapleExpression {
    Expression expression;  // its names are those below, and "L[2]" of a list of parameters L
    std::vector<std::pair<std::string, std::size_t>> names;  // with their offsets in the text
    std::size_t offset = 0;
    std::size_t most_index = 0;  // the greatest in L[...]
};

/// A letter or `_`, then letters, digits and `_`; empty if the next token is none. Not gone past.
std::string next_maple_name(Scanner& scanner);

/// The expression at the next token. `parameters` is the name of the list of the function in which it
/// stands, or empty. Fails on what it does not know, on brackets more than 100 deep, and on more than
/// 150 operators and calls.
MapleExpression read_maple_expression(Scanner& scanner, const std::string& parameters);

/// The text of an expression of the notation in Maple; `name_text` says what stands for a name. It
/// reads back as an expression with the same values. Throws Error with the part that Maple's
/// arithmetic has no operator for: relations, logic and words.
std::string maple_text(const Expression& expression,
                       const std::function<std::string(const std::string&)>& name_text);

}  // namespace algae
