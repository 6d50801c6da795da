#pragma once

#include <map>
#include <string_view>

#include "notation/claim_reading.hpp"
#include "notation/claim_scanner.hpp"

namespace algae {

// Words, and what is made of them between braces. All throw `SyntaxError`.

/// The word that is the whole of the text; ε is the empty word, a text without anything is none.
Word parse_claimed_word(std::string_view text, ClaimReading& reading);

/// Reads the finite set `{a, ab, ε}` that stands next.
Language parse_set(ClaimScanner& scanner, ClaimReading& reading);

/// Whether a morphism between braces stands next, not a set of words: there is an arrow between them.
bool is_morphism(ClaimScanner& scanner);

/// Reads the morphism `{ a -> ab; b -> ε }` that stands next.
std::map<Symbol, Word> parse_morphism(ClaimScanner& scanner, ClaimReading& reading);

}  // namespace algae
