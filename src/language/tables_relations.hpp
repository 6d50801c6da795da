#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "language/automaton.hpp"
#include "system/et0l.hpp"

namespace algae {

/// The states of a deterministic automaton from which something is accepted, numbered anew: a
/// letter leads from one to another or nowhere.
struct UsefulStates {
    static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

    std::size_t letters = 0;
    std::size_t initial = nowhere;  // nowhere if nothing is accepted
    std::vector<char> accepting;
    std::vector<std::size_t> transitions;

    std::size_t states() const { return accepting.size(); }
    std::size_t step(std::size_t state, Symbol letter) const {
        return transitions[state * letters + letter];
    }
};

/// Of an automaton over at least `letters` letters; it refuses those that it does not know.
UsefulStates useful_states(const Dfa& automaton, std::size_t letters);

/// The system whose L(G) is asked about, and what words derived from its letters do to the states
/// of an automaton. A state of the walk is, for every accessible letter and every state of the
/// automaton, a row of bits: the states to which some word leads that the letter derives by a given
/// sequence of tables. The rows of a sequence are found from those of the sequence without its
/// first table. System and automaton must outlive it.
class Relations {
public:
    using State = std::vector<std::uint64_t>;

    Relations(const ET0L& system, const UsefulStates& automaton);

    State first() const;
    /// O(states^2 * states / 64 * size of the table).
    State next(const State& rows, std::uint32_t table) const;
    /// Whether the axiom derives an accepted word.
    bool stops(const State& rows) const;
    std::uint64_t bytes(const State& rows) const { return rows.size() * sizeof(std::uint64_t); }
    std::size_t hash(const State& rows) const;

private:
    std::size_t at(Symbol a, std::size_t state) const {
        return (place_[a] * automaton_->states() + state) * width_;
    }
    State reached(const State& rows, std::size_t from, const Word& letters) const;

    const ET0L* system_;
    const UsefulStates* automaton_;
    std::vector<Symbol> letters_;
    std::vector<std::size_t> place_;  // by symbol: its place in letters_
    std::size_t width_;               // of a row, in words of 64 bits
};

}  // namespace algae
