#include "language/language.hpp"

#include <algorithm>

#include "exact/exact.hpp"
#include "language/detail/letters.hpp"
#include "language/detail/regular.hpp"

// Finiteness of the language of an 0L system, by what can become of its letters.
//
// Theorem. Call a letter lasting if some derivation from it never becomes empty. L(G) is infinite if and only
// if some accessible letter a has a rule a -> u b v where b derives a word with a in it and u v has a lasting
// letter.
// Proof. With such a rule, n rounds from a to a give a and n lasting letters, each of which is kept from then
// on. Without it, a lasting letter on a cycle is followed by one lasting letter as long as it stays among the
// letters of its cycles, and cycles can only be left for others that do not lead back, so the number of lasting
// letters of a word is bounded; letters that do not last are gone after as many steps as there are letters, so
// their number is bounded too. (For D0L systems: a bounded growth function, Rozenberg and Salomaa 1980, I.3.)
//
// So the decision needs a least fixed point (lasting letters) and the strongly connected components of the
// lasting letters.
//
// For a D0L system with a finite language the generations repeat. Once every lasting letter lies on a cycle of
// letters, a word is back when all of them are, so the period is the least common multiple of the lengths of
// their cycles. It can be far too long to follow: generations are compared across it by squaring h^period.

namespace algae {

namespace {

/// Least fixed point: a letter does not last if no successor has a letter that lasts.
std::vector<char> lasting_letters(const OL& system) {
    std::vector<char> lasting(system.alphabet->size(), 0);
    for (const Symbol a : system.letters) lasting[a] = 1;
    for (bool changed = true; changed;) {
        changed = false;
        for (const Symbol a : system.letters) {
            if (!lasting[a]) continue;
            const auto& choices = system.successors[a];
            const bool stays =
                std::any_of(choices.begin(), choices.end(), [&](const Word& successor) {
                    return std::any_of(successor.begin(), successor.end(),
                                       [&](Symbol b) { return lasting[b] != 0; });
                });
            if (!stays) {
                lasting[a] = 0;
                changed = true;
            }
        }
    }
    return lasting;
}

/// In round n those letters are found that can be gone after n steps and not before.
std::vector<std::optional<std::uint64_t>> shortest_lives(const OL& system) {
    std::vector<std::optional<std::uint64_t>> life(system.alphabet->size());
    for (std::uint64_t steps = 1;; ++steps) {
        std::vector<Symbol> found;
        for (const Symbol a : system.letters) {
            const auto& choices = system.successors[a];
            if (!life[a] && std::any_of(choices.begin(), choices.end(), [&](const Word& successor) {
                    return std::all_of(successor.begin(), successor.end(),
                                       [&](Symbol b) { return life[b].has_value(); });
                }))
                found.push_back(a);
        }
        if (found.empty()) return life;
        for (const Symbol a : found) life[a] = steps;
    }
}

std::vector<std::size_t> lasting_components(const OL& system, const std::vector<char>& lasting) {
    std::vector<std::vector<std::size_t>> successors(system.alphabet->size());
    for (const Symbol a : system.letters)
        for (const Word& successor : system.successors[a])
            for (const Symbol b : successor)
                if (lasting[a] && lasting[b]) successors[a].push_back(b);
    std::vector<std::size_t> component = strong_components(successors);
    for (std::size_t a = 0; a < component.size(); ++a)
        component[a] = lasting[a] ? component[a] + 1 : 0;
    return component;
}

std::optional<Pump> pump(const OL& system, const LetterFutures& futures, Symbol a,
                         std::size_t choice) {
    const Word& successor = system.successors[a][choice];
    std::optional<std::size_t> again, other;
    for (std::size_t i = 0; i < successor.size(); ++i) {
        if (!futures.lasting[successor[i]]) continue;
        if (!again && futures.component[successor[i]] == futures.component[a])
            again = i;
        else if (!other)
            other = i;
    }
    if (!futures.lasting[a] || !again || !other) return std::nullopt;
    return Pump{a, choice, *again, *other};
}

}  // namespace

Word generation_after(const std::vector<Word>& images, const Word& word, const Budget& budget) {
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

LetterFutures letter_futures(const OL& system) {
    LetterFutures futures{lasting_letters(system), shortest_lives(system), {}, {}};
    futures.component = lasting_components(system, futures.lasting);
    futures.growing.assign(system.alphabet->size(), 0);
    for (const Symbol a : system.letters)
        for (std::size_t choice = 0; choice < system.successors[a].size(); ++choice)
            if (pump(system, futures, a, choice)) futures.growing[a] = 1;
    for (bool changed = true; changed;) {
        changed = false;
        for (const Symbol a : system.letters)
            for (const Word& successor : system.successors[a])
                for (const Symbol b : successor)
                    if (futures.growing[b] && !futures.growing[a])
                        futures.growing[a] = changed = true;
    }
    return futures;
}

bool is_deterministic(const OL& system) {
    return std::all_of(system.letters.begin(), system.letters.end(),
                       [&](Symbol a) { return system.successors[a].size() == 1; });
}

std::optional<Pump> first_pump(const OL& system, const LetterFutures& futures) {
    for (const Symbol a : system.letters)
        for (std::size_t choice = 0; choice < system.successors[a].size(); ++choice)
            if (const auto found = pump(system, futures, a, choice)) return found;
    return std::nullopt;
}

std::uint32_t erasing_choice(const OL& system, const LetterFutures& futures, Symbol letter) {
    const auto& choices = system.successors[letter];
    if (!futures.shortest_life[letter])
        throw Error("no rule erases " + system.alphabet->name(letter));
    for (std::uint32_t choice = 0; choice < choices.size(); ++choice)
        if (std::all_of(choices[choice].begin(), choices[choice].end(), [&](Symbol b) {
                return futures.shortest_life[b] &&
                       *futures.shortest_life[b] < *futures.shortest_life[letter];
            }))
            return choice;
    throw Error("the letters of another system");
}

namespace {

/// The rules by which `from` derives a word with `to` in it, both in one component: a shortest way.
std::vector<RuleUse> way(const OL& system, const LetterFutures& futures, Symbol from, Symbol to) {
    std::vector<std::optional<RuleUse>> reached_by(system.alphabet->size());
    std::vector<Symbol> queue{from};
    for (std::size_t i = 0; i < queue.size() && queue[i] != to; ++i) {
        const auto& choices = system.successors[queue[i]];
        for (std::size_t choice = 0; choice < choices.size(); ++choice)
            for (const Symbol b : choices[choice])
                if (b != from && !reached_by[b] &&
                    futures.component[b] == futures.component[from]) {
                    reached_by[b] = RuleUse{queue[i], choice};
                    queue.push_back(b);
                }
    }
    std::vector<RuleUse> rules;
    for (Symbol at = to; at != from; at = rules.back().letter) rules.push_back(*reached_by[at]);
    std::reverse(rules.begin(), rules.end());
    return rules;
}

/// left after right, on the accessible letters.
std::vector<Word> composed(const OL& system, const std::vector<Word>& left,
                           const std::vector<Word>& right, const Budget& budget) {
    std::vector<Word> images(right.size());
    std::uint64_t letters = 0;
    for (const Symbol a : system.letters) {
        images[a] = generation_after(left, right[a], budget);
        letters += images[a].size();
        budget.check_memory(letters * sizeof(Symbol), "the words of a power of the rules");
    }
    return images;
}

std::vector<Word> power_of_rules(const OL& system, std::vector<Word> rules, Integer n,
                                 const Budget& budget) {
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
    for (const RuleUse& rule : way(system, futures, successor[pump->again], pump->letter))
        round.rules.push_back(rule);
    return {false, std::move(round)};
}

Repetition repetition(const OL& system, const Budget& budget) {
    if (!is_deterministic(system))
        throw Error("a letter has several rules: the generations are no sequence of words");
    const LetterFutures futures = letter_futures(system);
    if (first_pump(system, futures))
        throw Error("the language is infinite: no generation comes again");
    std::vector<Word> rules(system.successors.size());
    for (const Symbol a : system.letters) rules[a] = system.successors[a].front();
    // After as many steps as there are letters, all lasting letters are on cycles.
    Word settled = system.axiom;
    for (std::size_t n = 0; n < system.letters.size(); ++n)
        settled = generation_after(rules, settled, budget);
    std::sort(settled.begin(), settled.end());
    settled.erase(std::unique(settled.begin(), settled.end()), settled.end());
    Repetition found;
    for (const Symbol a : settled)
        if (futures.lasting[a])
            found.period = lcm(found.period, Integer(cycle_length(futures, rules, a)));
    const std::vector<Word> round = power_of_rules(system, rules, found.period, budget);
    for (Word word = system.axiom; generation_after(round, word, budget) != word;
         word = generation_after(rules, word, budget))
        ++found.preperiod;
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
