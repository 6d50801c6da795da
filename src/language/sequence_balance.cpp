#include "language/sequence_balance.hpp"

#include <algorithm>
#include <map>

namespace algae {

namespace {

/// A state by number; the number of states stands for refusal.
using State = std::uint32_t;
/// Where each state goes, by letter.
using Maps = std::vector<std::vector<State>>;

Maps first_maps(const SequencePair& systems, const std::vector<Overflow>& states) {
    const State refusal = static_cast<State>(states.size());
    std::map<Overflow, State> numbers;
    for (State q = 0; q < refusal; ++q) numbers.emplace(states[q], q);
    Maps maps(systems.alphabet->size());
    for (const Symbol a : systems.left.letters)
        for (const Overflow& overflow : states) {
            const OverflowStep step = overflow_step(systems, overflow, a);
            const auto found = step.next ? numbers.find(*step.next) : numbers.end();
            maps[a].push_back(found == numbers.end() ? refusal : found->second);
        }
    return maps;
}

/// Where the word leads from a state.
State led(const Maps& maps, const Word& word, State from, State refusal) {
    for (const Symbol a : word) {
        if (from == refusal) return refusal;
        from = maps[a][from];
    }
    return from;
}

}  // namespace

BalanceAttempt try_balance(const SequencePair& systems, std::vector<Overflow> states,
                           const Budget& budget) {
    const State refusal = static_cast<State>(states.size());
    budget.check_memory(states.size() * systems.left.letters.size() * 3 * sizeof(State),
                        "the maps of overflows");
    Maps maps = first_maps(systems, states), remembered = maps, next = maps;
    std::uint64_t earlier = 0;
    for (std::uint64_t step = 0, until = 1;; ++step) {
        budget.check();
        if (step > earlier && maps == remembered) {
            std::size_t bound = 0;
            for (const Overflow& overflow : states) bound = std::max(bound, overflow.word.size());
            return {Balance{bound, std::move(states), step, earlier}, 0};
        }
        if (led(maps, systems.left.axiom, 0, refusal) != 0) return {std::nullopt, step};
        if (step == until) {
            remembered = maps;
            earlier = step;
            until *= 2;
        }
        for (const Symbol a : systems.left.letters)
            for (State q = 0; q < refusal; ++q)
                next[a][q] = led(maps, systems.left.successor(a), q, refusal);
        std::swap(maps, next);
    }
}

}  // namespace algae
