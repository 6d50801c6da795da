#include "verify/finite_language.hpp"

#include <algorithm>
#include <set>

#include "word/word_sets.hpp"

namespace algae {

bool FiniteLanguage::contains(const Word& word) const {
    return std::binary_search(words.begin(), words.end(), word, shortlex_less);
}

FiniteLanguage make_finite_language(std::shared_ptr<const Alphabet> alphabet,
                                    std::vector<Word> words) {
    std::sort(words.begin(), words.end(), shortlex_less);
    words.erase(std::unique(words.begin(), words.end()), words.end());
    return {std::move(alphabet), std::move(words)};
}

FiniteLanguage finite_language(const std::vector<std::string>& words) {
    std::set<char> characters;
    for (const std::string& word : words) characters.insert(word.begin(), word.end());
    auto alphabet = std::make_shared<Alphabet>();
    for (const char character : characters) alphabet->symbol(std::string(1, character));
    std::vector<Word> all;
    for (const std::string& word : words) {
        Word& symbols = all.emplace_back();
        for (const char character : word)
            symbols.push_back(alphabet->symbol(std::string(1, character)));
    }
    return make_finite_language(std::move(alphabet), std::move(all));
}

std::vector<Symbol> letters_of(const FiniteLanguage& language) {
    std::set<Symbol> letters;
    for (const Word& word : language.words) letters.insert(word.begin(), word.end());
    return {letters.begin(), letters.end()};
}

std::string to_string(const FiniteLanguage& language) {
    std::string text = "{";
    for (const Word& word : language.words)
        text += (text.size() > 1 ? ", " : "") + spell(*language.alphabet, word);
    return text + "}";
}

}  // namespace algae
