#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "language/language.hpp"
#include "language/regular_language.hpp"

namespace algae {

/// All words of a language, and what was worked out on the way, in sentences.
struct FiniteValue {
    std::vector<Word> words;  // shorter ones first, then by symbol numbers
    std::vector<std::string> argument;
};

/// The words of a language that is found to be finite and has at most 100,000 words: finite sets, finite
/// languages of systems, what operations make of these, and what intersection and difference leave of a
/// finite set, word by word. Nothing if it is not found to be finite, or a word could not be decided.
/// Throws what budget.check throws, BoundReached where a table is too large.
std::optional<FiniteValue> finite_value(const Language& language, const Alphabet& alphabet,
                                        const Budget& budget = {});

/// The minimal automaton of an expression whose parts are regular: finite sets, finite languages of systems,
/// and all operations on them. Nothing if a part is an infinite language of a system.
std::optional<RegularLanguage> regular_value(const Language& language, const Alphabet& alphabet,
                                             const Budget& budget = {});

/// Whether a system occurs in the expression.
bool has_system(const Language& language);

/// The image of a word; nothing if one of its letters has none.
std::optional<Word> image_of(const Word& word, const std::map<Symbol, Word>& morphism);

/// The letters that have an image, in increasing order.
std::vector<Symbol> domain_of(const std::map<Symbol, Word>& morphism);

/// The images by symbol, for operations on automata whose words have letters with images only.
std::vector<Word> images_by_symbol(const std::map<Symbol, Word>& morphism);

}  // namespace algae
