#pragma once

#include <cstddef>
#include <vector>

#include "language/automaton.hpp"

namespace algae {

/// A generalised sequential machine: an automaton that writes a word for each letter that it reads. It
/// relates the words that lead from the initial to an accepting state to what is written on the way.
struct Gsm {
    struct Move {
        std::size_t from = 0;
        Symbol letter = 0;
        std::size_t to = 0;
        Word output;
    };
    std::size_t initial = 0;
    std::vector<char> accepting;  // by state
    std::vector<Move> moves;

    std::size_t states() const { return accepting.size(); }
};

/// The machine that writes what it reads, if the automaton accepts it.
///
/// Example: copying(Dfa{1, 0, {1, 0}, {1, 1}}).moves.size() == 2
Gsm copying(const Dfa& automaton);

/// At most one move for each state and letter.
///
/// Example: is_deterministic(copying(Dfa{1, 0, {1, 0}, {1, 1}}))
bool is_deterministic(const Gsm& machine);

}  // namespace algae
