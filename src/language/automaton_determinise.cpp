#include <algorithm>
#include <cstdint>
#include <map>
#include <unordered_map>

#include "language/automaton.hpp"

namespace algae {

namespace {

/// Sorted numbers of states.
using States = std::vector<std::size_t>;

struct Hash {
    std::size_t operator()(const States& states) const {
        std::uint64_t hash = states.size();
        for (const std::size_t s : states) hash = (hash ^ s) * 0x9E3779B97F4A7C15u + (hash >> 29);
        return static_cast<std::size_t>(hash);
    }
};

/// The states and all that silent moves lead to.
States closed(const Nfa& automaton, States states, std::vector<char>& seen) {
    States found;
    const auto see = [&](std::size_t s) {
        if (seen[s]) return;
        seen[s] = 1;
        found.push_back(s);
    };
    for (const std::size_t s : states) see(s);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const std::size_t s : automaton.states[found[i]].silent) see(s);
    for (const std::size_t s : found) seen[s] = 0;
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

Dfa determinised(const Nfa& automaton, const Budget& budget) {
    std::size_t letters = 0;
    for (const Nfa::State& state : automaton.states)
        for (const auto& [letter, to] : state.moves) letters = std::max<std::size_t>(letters, letter + 1);
    std::vector<char> seen(automaton.states.size(), 0);
    std::unordered_map<States, std::size_t, Hash> number;
    std::vector<const States*> sets;
    Dfa found{letters, 0, {}, {}};
    std::uint64_t bytes = 0;
    const auto number_of = [&](States states) {
        const auto [place, is_new] = number.try_emplace(std::move(states), sets.size());
        if (is_new) {
            sets.push_back(&place->first);
            const bool accepts = std::any_of(place->first.begin(), place->first.end(),
                                             [&](std::size_t s) { return automaton.states[s].accepting; });
            found.accepting.push_back(accepts);
            bytes += (place->first.size() + letters + 8) * sizeof(std::size_t);
        }
        return place->second;
    };
    number_of(closed(automaton, automaton.initial, seen));
    for (std::size_t s = 0; s < sets.size(); ++s) {
        budget.check();
        budget.check_memory(bytes, "a deterministic automaton");
        std::map<Symbol, States> reached;
        for (const std::size_t from : *sets[s])
            for (const auto& [letter, to] : automaton.states[from].moves) reached[letter].push_back(to);
        found.transitions.resize((s + 1) * letters);
        for (Symbol a = 0; a < letters; ++a)
            found.transitions[s * letters + a] = number_of(closed(automaton, std::move(reached[a]), seen));
    }
    return found;
}

}  // namespace algae
