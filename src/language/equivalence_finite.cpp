#include "language/equivalence_finite.hpp"

#include "base/error.hpp"

namespace algae {

namespace {

void check_size(std::uint64_t letters, const Budget& budget) {
    budget.check();
    budget.check_memory(letters * sizeof(Symbol), "the words of the finite language");
}

}  // namespace

OL ol_of(const D0L& system) {
    OL found{system.alphabet, system.axiom, {}, system.letters, system.name};
    for (const Word& image : system.rules.images) found.successors.push_back({image});
    return found;
}

std::set<Word> words_of(const D0L& system, const Budget& budget) {
    std::set<Word> words;
    std::uint64_t letters = 0;
    Word word = system.axiom;
    while (words.insert(word).second) {
        letters += word.size() + 24;
        check_size(letters, budget);
        word = system.rules(word);
    }
    return words;
}

std::optional<std::uint64_t> first_generation_outside(const D0L& system,
                                                      const std::set<Word>& words,
                                                      const Budget& budget) {
    Word word = system.axiom;
    for (std::uint64_t generation = 0; generation <= words.size(); ++generation) {
        if (!words.contains(word)) return generation;
        word = system.rules(word);
        check_size(word.size(), budget);
    }
    return std::nullopt;  // some word has come again
}

}  // namespace algae
