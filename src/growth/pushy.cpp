#include "growth/pushy.hpp"

#include <algorithm>

namespace algae {

namespace {

/// A pusher to the right: a cycle of last growing letters that adds what follows them.
std::optional<Pusher> to_the_right(const std::vector<Word>& images, const std::vector<char>& accessible,
                                   const std::vector<char>& growing, const Budget& budget) {
    std::vector<Symbol> last(images.size(), 0);
    std::vector<Word> after(images.size());
    for (Symbol a = 0; a < images.size(); ++a) {
        if (!accessible[a] || !growing[a]) continue;
        const auto found = std::find_if(images[a].rbegin(), images[a].rend(), [&](Symbol b) { return growing[b] != 0; });
        last[a] = *found;
        after[a] = Word(found.base(), images[a].end());
    }
    std::vector<std::size_t> seen(images.size(), 0);  // the round in which it was seen
    std::size_t round = 0;
    for (Symbol start = 0; start < images.size(); ++start) {
        if (!accessible[start] || !growing[start] || seen[start] != 0) continue;
        ++round;
        Symbol a = start;
        for (; seen[a] == 0; a = last[a]) seen[a] = round;
        if (seen[a] != round) continue;
        std::size_t steps = 0;
        bool adds = false;
        Symbol b = a;
        do {
            adds = adds || !after[b].empty();
            b = last[b];
            ++steps;
        } while (b != a);
        if (!adds) continue;
        Word run;
        for (std::size_t i = 0; i < steps; ++i, b = last[b]) {  // b run goes to last after h(run)
            Word longer = after[b];
            const Word more = image(images, run);
            longer.insert(longer.end(), more.begin(), more.end());
            run = std::move(longer);
            budget.check();
            budget.check_memory(run.size() * sizeof(Symbol), "the word that a letter pushes");
        }
        return Pusher{a, steps, run, false};
    }
    return std::nullopt;
}

}  // namespace

std::optional<Pusher> pusher_of(const std::vector<Word>& images, const Word& word, const Budget& budget) {
    const auto accessible = accessible_letters(images, word);
    const auto growing = growing_letters(images);
    if (auto found = to_the_right(images, accessible, growing, budget)) return found;
    auto found = to_the_right(mirrored({{}, images}).images, accessible, growing, budget);
    if (found) {
        std::reverse(found->run.begin(), found->run.end());
        found->left = true;
    }
    return found;
}

std::optional<Pusher> pusher_of(const D0L& system, const Budget& budget) {
    const Iterated rest = skeleton(system);
    auto found = pusher_of(rest.images, rest.axiom, budget);
    if (!found) return found;
    // Mortal letters within the run: the run as the system itself writes it.
    Word word{found->letter};
    for (std::size_t i = 0; i < found->steps; ++i) {
        word = image(system.rules.images, word);
        budget.check();
        budget.check_memory(word.size() * sizeof(Symbol), "the image of the letter that pushes");
    }
    const auto growing = growing_letters(system.rules.images);
    const auto grows = [&](Symbol a) { return growing[a] != 0; };
    if (found->left)
        found->run = Word(word.begin(), std::find_if(word.begin(), word.end(), grows));
    else
        found->run = Word(std::find_if(word.rbegin(), word.rend(), grows).base(), word.end());
    return found;
}

}  // namespace algae
