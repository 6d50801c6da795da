#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "word/alphabet.hpp"

namespace algae {

/// A complete deterministic automaton over the symbols 0, 1, ..., letters - 1. It has at least one
/// state. Words with other symbols are not accepted.
struct Dfa {
    std::size_t letters = 0;
    std::size_t initial = 0;
    std::vector<char> accepting;          // by state
    std::vector<std::size_t> transitions;  // of state s with letter a: transitions[s * letters + a]

    std::size_t states() const { return accepting.size(); }
    std::size_t step(std::size_t state, Symbol letter) const { return transitions[state * letters + letter]; }
    bool accepts(const Word& word) const;
    bool operator==(const Dfa&) const = default;
};

/// A nondeterministic automaton with silent moves.
struct Nfa {
    struct State {
        std::vector<std::pair<Symbol, std::size_t>> moves;
        std::vector<std::size_t> silent;  // where it can go without reading
        bool accepting = false;
    };
    std::vector<State> states;
    std::vector<std::size_t> initial;

    /// A new state; its number.
    std::size_t add_state(bool accepting = false);
    /// A way from one state to another that reads the word, through new states.
    void add_path(std::size_t from, const Word& word, std::size_t to);
    /// All states of another automaton, none of them initial; what must be added to their numbers.
    std::size_t add_states(const Nfa& other);
};

/// The automaton as a nondeterministic one, without the states from which nothing is accepted.
Nfa as_nfa(const Dfa& automaton);

/// The automaton that reads words backwards.
Nfa reversed(const Nfa& automaton);

/// The same language over more letters: a state is added that refuses them.
Dfa widened(const Dfa& automaton, std::size_t letters);

/// By sets of states (Rabin and Scott 1959): up to 2^states of them. Throws BoundReached if the result
/// takes more than budget.memory.
///
/// Example: determinised(as_nfa(Dfa{1, 0, {1}, {0}})).accepts({0, 0})
Dfa determinised(const Nfa& automaton, const Budget& budget = {});

/// The automaton with the least number of states, in a form that depends on the language alone: it has
/// as many letters as needed to have every letter of the language's words, and its states are
/// numbered in shortlex order of the first words that lead to them. By Hopcroft's algorithm (1971), O(letters *
/// states * log(states)).
///
/// Example: minimal(Dfa{1, 0, {1, 1}, {1, 0}}) == Dfa{1, 0, {1}, {0}}
Dfa minimal(const Dfa& automaton);

}  // namespace algae
