#pragma once

#include <string_view>
#include <vector>

#include "notation/findings.hpp"
#include "notation/lexicon.hpp"
#include "notation/source.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// The word that is the whole of `text`: symbols, some with arguments in brackets; white space
/// separates, ε is nothing. Linear; a word without arguments takes four bytes a symbol.
/// Where `splices` are allowed, `<w>` stands for the word that the expression w gives; a relation in
/// it needs brackets. Throws `SyntaxError`.
ModuleWord parse_word(std::string_view text, Lexicon& lexicon, const Source& source,
                      bool splices = false);

/// The word in quotes that `here` stands at, as an expression; moves `here` behind it. `quotes` counts
/// the words in quotes around it, at most 20. Throws `SyntaxError`.
Expression parse_quoted(const char*& here, const char* end, Lexicon& lexicon, const Source& source,
                        std::size_t quotes);

/// Symbols without arguments. Throws `SyntaxError`.
Word parse_symbols(std::string_view text, Lexicon& lexicon);

/// Adds a finding for each bracket of the word without its other half; `text` is what the word was
/// read from.
void check_brackets(const ModuleWord& word, std::string_view text, Lexicon& lexicon,
                    const Source& source, Findings& findings);

}  // namespace algae
