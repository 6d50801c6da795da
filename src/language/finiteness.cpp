#include "language/finiteness.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "language/finiteness_letters.hpp"
#include "language/regular_words.hpp"
#include "language/tables_words.hpp"

namespace algae {

namespace {

/// The rules by which `from` derives a word with `to` in it, both in one component: a shortest way.
std::vector<RuleUse> way(const OL& system, const LetterFutures& futures, Symbol from, Symbol to) {
    std::vector<std::optional<RuleUse>> reached_by(system.alphabet->size());
    std::vector<Symbol> queue{from};
    for (std::size_t i = 0; i < queue.size() && queue[i] != to; ++i) {
        const auto& choices = system.successors[queue[i]];
        for (std::size_t choice = 0; choice < choices.size(); ++choice)
            for (const Symbol b : choices[choice])
                if (b != from && !reached_by[b] && futures.component[b] == futures.component[from]) {
                    reached_by[b] = RuleUse{queue[i], choice};
                    queue.push_back(b);
                }
    }
    std::vector<RuleUse> rules;
    for (Symbol at = to; at != from; at = rules.back().letter) rules.push_back(*reached_by[at]);
    std::reverse(rules.begin(), rules.end());
    return rules;
}

Word after(const std::vector<Word>& images, const Word& word, const Budget& budget) {
    Word next;
    for (const Symbol a : word) {
        next.insert(next.end(), images[a].begin(), images[a].end());
        if (next.size() > budget.letters)
            throw BoundReached(Bound::letters,
                               "a generation has more than " + std::to_string(budget.letters) +
                                   " letters, the bound set" + budget.by(Bound::letters));
    }
    return next;
}

/// left after right, on the accessible letters.
std::vector<Word> composed(const OL& system, const std::vector<Word>& left, const std::vector<Word>& right,
                           const Budget& budget) {
    std::vector<Word> images(right.size());
    std::uint64_t letters = 0;
    for (const Symbol a : system.letters) {
        images[a] = after(left, right[a], budget);
        letters += images[a].size();
        budget.check_memory(letters * sizeof(Symbol), "the words of a power of the rules");
    }
    return images;
}

std::vector<Word> power_of_rules(const OL& system, std::vector<Word> rules, Integer n, const Budget& budget) {
    std::vector<Word> found(rules.size());
    for (const Symbol a : system.letters) found[a] = Word{a};
    while (!n.is_zero()) {
        budget.check();
        if (remainder(n, 2) == 1) found = composed(system, rules, found, budget);
        n = floor_divide(n, 2);
        if (!n.is_zero()) rules = composed(system, rules, rules, budget);
    }
    return found;
}

/// How many steps a lasting letter on a cycle takes to come back; 0 if it is not on a cycle.
std::uint64_t cycle_length(const LetterFutures& futures, const std::vector<Word>& rules, Symbol a) {
    Symbol at = a;
    for (std::uint64_t steps = 1; steps <= rules.size(); ++steps) {
        const auto next = std::find_if(rules[at].begin(), rules[at].end(), [&](Symbol b) {
            return futures.lasting[b] && futures.component[b] == futures.component[a];
        });
        if (next == rules[at].end()) return 0;
        at = *next;
        if (at == a) return steps;
    }
    return 0;
}

}  // namespace

Finiteness finiteness(const OL& system) {
    const LetterFutures futures = letter_futures(system);
    const auto pump = first_pump(system, futures);
    if (!pump) return {true, std::nullopt};
    const Word& successor = system.successors[pump->letter][pump->choice];
    EndlessRound round{{{pump->letter, pump->choice}}, successor[pump->other]};
    for (const RuleUse& rule : way(system, futures, successor[pump->again], pump->letter)) round.rules.push_back(rule);
    return {false, std::move(round)};
}

Repetition repetition(const OL& system, const Budget& budget) {
    if (!is_deterministic(system)) throw Error("a letter has several rules: the generations are no sequence of words");
    const LetterFutures futures = letter_futures(system);
    if (first_pump(system, futures)) throw Error("the language is infinite: no generation comes again");
    std::vector<Word> rules(system.successors.size());
    for (const Symbol a : system.letters) rules[a] = system.successors[a].front();
    // After as many steps as there are letters, all lasting letters are on cycles.
    Word settled = system.axiom;
    for (std::size_t n = 0; n < system.letters.size(); ++n) settled = after(rules, settled, budget);
    std::sort(settled.begin(), settled.end());
    settled.erase(std::unique(settled.begin(), settled.end()), settled.end());
    Repetition found;
    for (const Symbol a : settled)
        if (futures.lasting[a]) found.period = lcm(found.period, Integer(cycle_length(futures, rules, a)));
    const std::vector<Word> round = power_of_rules(system, rules, found.period, budget);
    for (Word word = system.axiom; after(round, word, budget) != word; word = after(rules, word, budget)) ++found.preperiod;
    return found;
}

Integer number_of_words(const OL& system, const Budget& budget) {
    if (first_pump(system, letter_futures(system))) throw Error("the language is infinite");
    if (is_deterministic(system)) {
        const Repetition found = repetition(system, budget);
        return Integer(found.preperiod) + found.period;
    }
    return *number_of_words(finite_words(as_et0l(system), budget));
}

}  // namespace algae
