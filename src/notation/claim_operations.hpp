#pragma once

#include <map>
#include <utility>
#include <vector>

#include "notation/claim_reading.hpp"

namespace algae {

/// How many operations a language may have inside each other, and what is said of more at a place.
constexpr std::size_t most_levels = 1000;
SyntaxError too_deep(const char* where);

/// The language that an operation makes of others; `where` it is written. Throws `SyntaxError` if the
/// expression becomes too deep or too large.
LanguageOperand combined_operand(LanguageTree::Kind kind, std::vector<LanguageOperand> parts,
                                 const char* where);

/// The words that are not in the language, over the letters that the claim declares or else those of the
/// language. Throws `SyntaxError` if there are none, or it has others.
LanguageOperand complement_operand(LanguageOperand part, const ClaimReading& reading,
                                   const char* where);

/// The image of the language under a morphism; `name` is what the text calls that. Throws `SyntaxError` if
/// a letter of the language has no image.
LanguageOperand image_operand(LanguageOperand part, const std::map<Symbol, Word>& morphism,
                              std::string_view name, const ClaimReading& reading);

LanguageOperand inverse_image_operand(LanguageOperand part, const std::map<Symbol, Word>& morphism,
                                      const char* where);

}  // namespace algae
