#include "language/automaton.hpp"

#include <algorithm>

namespace algae {

bool Dfa::accepts(const Word& word) const {
    std::size_t state = initial;
    for (const Symbol a : word) {
        if (a >= letters) return false;
        state = step(state, a);
    }
    return accepting[state] != 0;
}

std::size_t Nfa::add_state(bool accepting) {
    states.push_back({{}, {}, accepting});
    return states.size() - 1;
}

void Nfa::add_path(std::size_t from, const Word& word, std::size_t to) {
    if (word.empty()) {
        states[from].silent.push_back(to);
        return;
    }
    for (std::size_t i = 0; i + 1 < word.size(); ++i) {
        const std::size_t between = add_state();
        states[from].moves.emplace_back(word[i], between);
        from = between;
    }
    states[from].moves.emplace_back(word.back(), to);
}

std::size_t Nfa::add_states(const Nfa& other) {
    const std::size_t shift = states.size();
    for (State state : other.states) {
        for (auto& [letter, to] : state.moves) to += shift;
        for (std::size_t& to : state.silent) to += shift;
        states.push_back(std::move(state));
    }
    return shift;
}

Nfa as_nfa(const Dfa& automaton) {
    // Backwards from the accepting states: the others are left without moves to them.
    std::vector<std::vector<std::size_t>> before(automaton.states());
    for (std::size_t s = 0; s < automaton.states(); ++s)
        for (Symbol a = 0; a < automaton.letters; ++a) before[automaton.step(s, a)].push_back(s);
    std::vector<char> useful(automaton.states(), 0);
    std::vector<std::size_t> queue;
    for (std::size_t s = 0; s < automaton.states(); ++s)
        if (automaton.accepting[s]) {
            useful[s] = 1;
            queue.push_back(s);
        }
    for (std::size_t i = 0; i < queue.size(); ++i)
        for (const std::size_t s : before[queue[i]])
            if (!useful[s]) {
                useful[s] = 1;
                queue.push_back(s);
            }
    Nfa found;
    for (std::size_t s = 0; s < automaton.states(); ++s) {
        found.add_state(automaton.accepting[s] != 0);
        for (Symbol a = 0; a < automaton.letters; ++a)
            if (useful[automaton.step(s, a)]) found.states[s].moves.emplace_back(a, automaton.step(s, a));
    }
    if (useful[automaton.initial]) found.initial.push_back(automaton.initial);
    return found;
}

Nfa reversed(const Nfa& automaton) {
    Nfa found;
    found.states.resize(automaton.states.size());
    for (std::size_t s = 0; s < automaton.states.size(); ++s) {
        for (const auto& [letter, to] : automaton.states[s].moves) found.states[to].moves.emplace_back(letter, s);
        for (const std::size_t to : automaton.states[s].silent) found.states[to].silent.push_back(s);
        if (automaton.states[s].accepting) found.initial.push_back(s);
    }
    for (const std::size_t s : automaton.initial) found.states[s].accepting = true;
    return found;
}

Dfa widened(const Dfa& automaton, std::size_t letters) {
    if (letters <= automaton.letters) return automaton;
    Dfa found{letters, automaton.initial, automaton.accepting, {}};
    const std::size_t dead = automaton.states();
    found.accepting.push_back(0);
    found.transitions.assign(found.states() * letters, dead);
    for (std::size_t s = 0; s < automaton.states(); ++s)
        for (Symbol a = 0; a < automaton.letters; ++a) found.transitions[s * letters + a] = automaton.step(s, a);
    return found;
}

}  // namespace algae
