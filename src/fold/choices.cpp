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

std::uint64_t below(std::mt19937_64& generator, std::uint64_t bound) {
    const std::uint64_t skip = (0 - bound) % bound;  // 2^64 mod bound values would be one too many
    std::uint64_t value;
    do value = generator();
    while (value < skip);
    return value % bound;
}

Word random_word(const OL& system, std::uint64_t n, std::mt19937_64& generator, const Budget& budget) {
    Word word = system.axiom;
    for (std::uint64_t step = 1; step <= n; ++step) {
        budget.check();
        Word next;
        std::uint64_t visits = 0;
        for (const Symbol a : word) {
            if (++visits % 65536 == 0) {
                budget.check();
                budget.check_memory((word.capacity() + next.capacity()) * sizeof(Symbol), "the word");
            }
            const auto& choices = system.successors[a];
            const Word& successor = choices.size() == 1 ? choices.front() : choices[below(generator, choices.size())];
            if (next.size() + successor.size() > budget.letters)
                throw BoundReached("generation " + std::to_string(step) + " has more than " +
                                   std::to_string(budget.letters) + " letters, the bound set by --max-letters");
            next.insert(next.end(), successor.begin(), successor.end());
        }
        if (next == word && std::all_of(word.begin(), word.end(), [&](Symbol a) {
                return system.successors[a].size() == 1;
            }))
            break;  // nothing will ever change
        word = std::move(next);
    }
    return word;
}

}  // namespace algae
