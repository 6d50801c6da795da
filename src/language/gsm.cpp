#include "language/gsm.hpp"

#include <set>
#include <utility>

namespace algae {

Gsm copying(const Dfa& automaton) {
    Gsm machine{automaton.initial, automaton.accepting, {}};
    for (std::size_t state = 0; state < automaton.states(); ++state)
        for (Symbol a = 0; a < automaton.letters; ++a)
            machine.moves.push_back({state, a, automaton.step(state, a), {a}});
    return machine;
}

bool is_deterministic(const Gsm& machine) {
    std::set<std::pair<std::size_t, Symbol>> seen;
    for (const Gsm::Move& move : machine.moves)
        if (!seen.emplace(move.from, move.letter).second) return false;
    return true;
}

}  // namespace algae
