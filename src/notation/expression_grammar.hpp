#pragma once

#include <string_view>
#include <vector>

#include "notation/lexicon.hpp"
#include "notation/source.hpp"
#include "system/expression.hpp"

namespace algae {

/// Reads one expression from `here` on, up to where it cannot go on, and moves `here` there.
/// Throws `SyntaxError`. Brackets nest at most 200 deep, operators at most 500. With a lexicon words
/// may stand in it, `"FF[+F]"` and `leaf(3)` of the systems that the lexicon knows; `quotes` counts
/// the words that it stands in itself, at most 20.
Expression parse_expression(const char*& here, const char* end, const Source& source,
                            Lexicon* lexicon = nullptr, std::size_t quotes = 0);

/// An expression that is the whole of `text`. Throws `SyntaxError`.
Expression parse_expression(std::string_view text, const Source& source);

/// Arguments in brackets, `(x*2, x+y)`, from `here` on. Throws `SyntaxError`.
std::vector<Expression> parse_arguments(const char*& here, const char* end, const Source& source,
                                        Lexicon* lexicon = nullptr, std::size_t quotes = 0);

}  // namespace algae
