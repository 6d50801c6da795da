#include "language/regular_induction.hpp"

#include "exact/integer.hpp"
#include "language/regular_images.hpp"
#include "language/regular_words.hpp"

namespace algae {

namespace {

/// The successors of at least so many letters.
RegularLanguage successors(const OL& system, Symbol letter, std::size_t least) {
    std::vector<Word> words;
    for (const Word& successor : system.successors[letter])
        if (successor.size() >= least) words.push_back(successor);
    return finite_set(words);
}

/// The words of the language with exactly one letter a marked, that is, replaced by a + letters.
RegularLanguage marked_once(const RegularLanguage& language, Symbol letters, const Budget& budget) {
    std::vector<Symbol> plain, marked, all;
    std::vector<Word> unmarked(2 * letters);
    for (Symbol a = 0; a < letters; ++a) {
        plain.push_back(a);
        marked.push_back(a + letters);
        unmarked[a] = unmarked[a + letters] = {a};
    }
    all = plain;
    all.insert(all.end(), marked.begin(), marked.end());
    std::vector<Word> one_mark;
    for (const Symbol a : marked) one_mark.push_back({a});
    const RegularLanguage once = concatenated(
        concatenated(all_words(plain), finite_set(one_mark), budget), all_words(plain), budget);
    return intersected(inverse_image(language, unmarked, all), once, budget);
}

}  // namespace

std::optional<RegularInduction> regular_induction(const RegularLanguage& language, const OL& system,
                                                  std::size_t most, const Budget& budget) {
    const Symbol letters = static_cast<Symbol>(language.automaton().letters);
    if (letters > system.successors.size()) return std::nullopt;
    std::vector<RegularLanguage> images(2 * letters);
    for (Symbol a = 0; a < letters; ++a) {
        images[a] = successors(system, a, 1);
        images[a + letters] = successors(system, a, 2);
    }
    const RegularLanguage derived = image(marked_once(language, letters, budget), images, budget);
    const RegularLanguage base = difference(language, derived, budget);
    const std::optional<Integer> count = number_of_words(base);
    if (!count || *count > Integer(most)) return std::nullopt;
    return RegularInduction{words_up_to(base, base.automaton().states(), budget)};
}

}  // namespace algae
