#include "fold/choices.hpp"

#include <algorithm>
#include <string>

#include "word/word_sets.hpp"

namespace algae {

namespace {

auto word_set_lift(const Budget& budget, std::optional<std::size_t> longest) {
    const WordSets sets(budget, longest.value_or(std::numeric_limits<std::size_t>::max()));
    const bool keep = !longest || *longest > 0;
    return Lift{sets, [keep](Symbol a) { return keep ? std::vector<Word>{Word{a}} : std::vector<Word>{}; }};
}

/// The same words in shortlex order of names.
std::vector<Word> by_name(std::vector<Word> words, const Alphabet& alphabet) {
    const auto rank = alphabet.ranks();
    std::sort(words.begin(), words.end(), [&](const Word& left, const Word& right) {
        if (left.size() != right.size()) return left.size() < right.size();
        return std::lexicographical_compare(left.begin(), left.end(), right.begin(), right.end(),
                                            [&](Symbol a, Symbol b) { return rank[a] < rank[b]; });
    });
    return words;
}

}  // namespace

std::vector<Word> words_of_generation(const OL& system, std::uint64_t n,
                                      std::optional<std::size_t> longest, const Budget& budget) {
    return by_name(fold(system, n, word_set_lift(budget, longest), budget), *system.alphabet);
}

std::vector<Word> words_up_to(const OL& system, std::size_t longest, const Budget& budget) {
    const auto lift = word_set_lift(budget, longest);
    const WordSets& sets = lift.monoid;
    using Family = std::vector<std::vector<Word>>;
    Family family(system.alphabet->size());
    for (const Symbol a : system.letters) family[a] = lift.letter(a);
    std::vector<Word> found;
    // The families repeat from some generation on (Brent 1980): one of them is remembered, and a
    // later one each time twice as many generations have passed.
    Family remembered = family;
    for (std::uint64_t steps = 0, until = 1;;) {
        budget.check();
        const Hom<WordSets> phi{sets, family};
        sets.add(found, phi(system.axiom));
        std::uint64_t bytes = 0;
        for (const Symbol a : system.letters) {
            family[a].clear();
            for (const Word& successor : system.successors[a]) sets.add(family[a], phi(successor));
            bytes += sizeof(family[a]);
            for (const Word& word : family[a]) bytes += sizeof(Word) + word.size() * sizeof(Symbol);
        }
        budget.check_memory(bytes, "the sets of words up to that length");
        if (family == remembered) break;
        if (++steps == until) {
            remembered = family;
            until *= 2;
            steps = 0;
        }
    }
    return by_name(std::move(found), *system.alphabet);
}

}  // namespace algae
