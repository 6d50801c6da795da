#pragma once

#include <memory>
#include <string>
#include <vector>

#include "word/alphabet.hpp"

namespace algae {

/// A finite set of words: each once, shorter words first, then by symbol numbers.
struct FiniteLanguage {
    std::shared_ptr<const Alphabet> alphabet;
    std::vector<Word> words;

    bool contains(const Word& word) const;
    bool operator==(const FiniteLanguage& other) const {
        return *alphabet == *other.alphabet && words == other.words;
    }
};

/// The language of these words, in any order and with any repetitions.
FiniteLanguage make_finite_language(std::shared_ptr<const Alphabet> alphabet,
                                    std::vector<Word> words);

/// The same with one character a letter, for tests and examples; letters are numbered in code order.
///
/// Example: to_string(finite_language({"aa", "", "a"})) == "{ε, a, aa}"
FiniteLanguage finite_language(const std::vector<std::string>& words);

/// The symbols that occur in some word, in increasing order.
std::vector<Symbol> letters_of(const FiniteLanguage& language);

/// The words between braces. Symbols are printed by name, the empty word as ε.
std::string to_string(const FiniteLanguage& language);

}  // namespace algae
