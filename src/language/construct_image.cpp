#include "language/construct_image.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "language/construct_draft.hpp"
#include "language/construct_propagating.hpp"
#include "language/construct_synchronised.hpp"

namespace algae {

namespace {

/// Throws Error if a terminal that a synchronised system reaches has no images.
void require_images(const ET0L& separate, const Substitution& images) {
    for (const Symbol a : accessible_letters(separate))
        if (separate.terminal[a] && !images.contains(a))
            throw Error("expected an image of every letter, found none of the letter " +
                        separate.alphabet->name(a));
}

bool has_empty(const std::vector<Word>& words) {
    return std::any_of(words.begin(), words.end(), [](const Word& word) { return word.empty(); });
}

/// The words of terminals that a word becomes if each letter is replaced by one of its non-empty images.
std::vector<Word> choices(Draft& draft, const Alphabet& alphabet, const Word& word,
                          const Substitution& images, const Budget& budget) {
    std::vector<Word> found{{}};
    for (const Symbol a : word) {
        std::vector<Word> longer;
        const auto known = images.find(a);  // absent only for letters that no derivation reaches
        if (known == images.end()) return {};
        for (const Word& image : known->second) {
            if (image.empty()) continue;
            const Word letters = draft.terminals(alphabet, image);
            for (const Word& begun : found) {
                longer.push_back(begun);
                longer.back().insert(longer.back().end(), letters.begin(), letters.end());
                budget.check();
                budget.check_memory(
                    longer.size() * (sizeof(Word) + longer.back().size() * sizeof(Symbol)),
                    "the images of a successor");
            }
        }
        found = std::move(longer);
    }
    return found;
}

}  // namespace

Substitution substitution(const std::map<Symbol, Word>& morphism) {
    Substitution found;
    for (const auto& [a, word] : morphism) found[a] = {word};
    return found;
}

ET0L e0l_image(const ET0L& system, const Substitution& images, const Budget& budget) {
    ET0L separate = synchronised(system);
    require_images(separate, images);
    bool vanishes = false;
    std::vector<char> may_go(separate.alphabet->size());
    for (const auto& [a, words] : images) may_go.at(a) = has_empty(words);
    if (std::find(may_go.begin(), may_go.end(), 1) != may_go.end()) {
        vanishes = can_vanish(separate, may_go, budget);
        separate = thinned(separate, may_go, budget);
    }

    Draft draft(*system.alphabet, 0);
    draft.add_tables(system);
    const auto letters = draft.copies(separate);
    for (std::size_t t = 0; t < separate.tables.size(); ++t) {
        for (Symbol a = 0; a < letters.size(); ++a)
            if (!separate.terminal[a])
                for (const Word& successor : separate.tables[t][a])
                    for (Word& word :
                         is_terminal_word(separate, successor)
                             ? choices(draft, *system.alphabet, successor, images, budget)
                             : std::vector<Word>{replaced(successor, letters)})
                        draft.add_rule(t, letters[a], std::move(word));
        if (vanishes) draft.add_rule(t, letters[separate.axiom.front()], {});
        draft.check(budget);
    }
    return draft.system({letters[separate.axiom.front()]}, "image");
}

ET0L table_image(const ET0L& system, const Substitution& images) {
    require_images(trimmed(system, *system.alphabet, system.name), images);
    Draft draft(*system.alphabet, 0);
    draft.add_tables(system);
    const auto copies = draft.copies(system);
    for (std::size_t t = 0; t < system.tables.size(); ++t) draft.add_rules(t, system, t, copies);
    const std::size_t end = draft.add_table();
    for (const auto& [a, words] : images)
        if (system.terminal.at(a))
            for (const Word& word : words)
                draft.add_rule(end, copies[a], draft.terminals(*system.alphabet, word));
    return draft.system(replaced(system.axiom, copies), "image");
}

}  // namespace algae
