#include "fold/interaction.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"

namespace algae {

namespace {

/// The letters that contexts see, and for each letter of the word how many of them stand before it.
struct Seen {
    Word letters;
    std::vector<std::size_t> before;
};

Seen seen(const IL& system, const Word& word) {
    Seen found;
    found.before.reserve(word.size());
    for (const Symbol a : word) {
        found.before.push_back(found.letters.size());
        if (!system.ignored[a]) found.letters.push_back(a);
    }
    return found;
}

bool matches(const IL::Rule& rule, const Word& letters, std::size_t before, std::size_t after) {
    return rule.left.size() <= before && rule.right.size() <= letters.size() - after &&
           std::equal(rule.left.begin(), rule.left.end(), letters.begin() + static_cast<std::ptrdiff_t>(before - rule.left.size())) &&
           std::equal(rule.right.begin(), rule.right.end(), letters.begin() + static_cast<std::ptrdiff_t>(after));
}

/// Calls each(word) for generations 0 to n.
template <class Each>
void generations(const IL& system, std::uint64_t n, const Budget& budget, Each each) {
    Word word = system.axiom;
    for (std::uint64_t step = 0;; ++step) {
        budget.check();
        if (word.size() > budget.letters)
            throw BoundReached("generation " + std::to_string(step) + " has more than " + std::to_string(budget.letters) +
                               " letters, the bound set by --max-letters");
        each(word);
        if (step == n) return;
        word = next_word(system, word);
    }
}

}  // namespace

Word next_word(const IL& system, const Word& word) {
    const Seen context = seen(system, word);
    Word next;
    next.reserve(word.size());
    for (std::size_t i = 0; i < word.size(); ++i) {
        const std::size_t before = context.before[i];
        const std::size_t after = before + (system.ignored[word[i]] ? 0 : 1);
        const auto& rules = system.rules[word[i]];
        const auto rule = std::find_if(rules.begin(), rules.end(), [&](const IL::Rule& candidate) {
            return matches(candidate, context.letters, before, after);
        });
        if (rule == rules.end())
            next.push_back(word[i]);
        else
            next.insert(next.end(), rule->successor.begin(), rule->successor.end());
    }
    return next;
}

std::vector<std::uint64_t> derived_lengths(const IL& system, std::uint64_t n, const Budget& budget) {
    std::vector<std::uint64_t> lengths;
    generations(system, n, budget, [&](const Word& word) {
        lengths.push_back(word.size());
        budget.check_memory(lengths.capacity() * sizeof(std::uint64_t), "the lengths");
    });
    return lengths;
}

Word derive(const IL& system, std::uint64_t n, const Budget& budget) {
    Word last;
    generations(system, n, budget, [&](const Word& word) { last = word; });
    return last;
}

}  // namespace algae
