#pragma once

#include <string_view>
#include <vector>

#include "notation/source.hpp"
#include "system/expression.hpp"

namespace algae {

/// Reads one expression from `here` on, up to where it cannot go on, and moves `here` there.
/// Throws `SyntaxError`. Brackets nest at most 200 deep, operators at most 500.
Expression parse_expression(const char*& here, const char* end, const Source& source);

/// An expression that is the whole of `text`. Throws `SyntaxError`.
Expression parse_expression(std::string_view text, const Source& source);

/// Arguments in brackets, `(x*2, x+y)`, from `here` on. Throws `SyntaxError`.
std::vector<Expression> parse_arguments(const char*& here, const char* end, const Source& source);

}  // namespace algae
