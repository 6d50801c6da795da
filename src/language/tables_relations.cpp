#include "language/tables_relations.hpp"

#include <algorithm>
#include <bit>
#include <boost/container_hash/hash.hpp>

namespace algae {

UsefulStates useful_states(const Dfa& automaton, std::size_t letters) {
    const Dfa wide = widened(automaton, letters);
    const Nfa ways = as_nfa(wide);
    std::vector<std::size_t> number(wide.states(), UsefulStates::nowhere);
    UsefulStates found;
    found.letters = wide.letters;
    for (std::size_t s = 0; s < wide.states(); ++s)
        if (wide.accepting[s] || !ways.states[s].moves.empty()) {
            number[s] = found.states();
            found.accepting.push_back(wide.accepting[s]);
        }
    found.initial = number[wide.initial];
    found.transitions.assign(found.states() * found.letters, UsefulStates::nowhere);
    for (std::size_t s = 0; s < wide.states(); ++s)
        for (const auto& [a, to] : ways.states[s].moves)
            found.transitions[number[s] * found.letters + a] = number[to];
    return found;
}

Relations::Relations(const ET0L& system, const UsefulStates& automaton)
    : system_(&system),
      automaton_(&automaton),
      letters_(accessible_letters(system)),
      place_(system.alphabet->size(), 0),
      width_((automaton.states() + 63) / 64) {
    for (std::size_t i = 0; i < letters_.size(); ++i) place_[letters_[i]] = i;
}

Relations::State Relations::first() const {
    State rows(letters_.size() * automaton_->states() * width_, 0);
    for (const Symbol a : letters_)
        for (std::size_t s = 0; s < automaton_->states(); ++s)
            if (const std::size_t to = automaton_->step(s, a); to != UsefulStates::nowhere)
                rows[at(a, s) + to / 64] |= std::uint64_t{1} << (to % 64);
    return rows;
}

Relations::State Relations::next(const State& rows, std::uint32_t table) const {
    State following(rows.size(), 0);
    for (const Symbol a : letters_)
        for (std::size_t s = 0; s < automaton_->states(); ++s)
            for (const Word& successor : system_->tables[table][a]) {
                const State row = reached(rows, s, successor);
                for (std::size_t k = 0; k < width_; ++k) following[at(a, s) + k] |= row[k];
            }
    return following;
}

bool Relations::stops(const State& rows) const {
    if (automaton_->initial == UsefulStates::nowhere) return false;
    const State row = reached(rows, automaton_->initial, system_->axiom);
    for (std::size_t s = 0; s < automaton_->states(); ++s)
        if (automaton_->accepting[s] && (row[s / 64] >> (s % 64) & 1) != 0) return true;
    return false;
}

std::size_t Relations::hash(const State& rows) const {
    return boost::hash_range(rows.begin(), rows.end());
}

Relations::State Relations::reached(const State& rows, std::size_t from,
                                    const Word& letters) const {
    State row(width_, 0);
    row[from / 64] = std::uint64_t{1} << (from % 64);
    for (const Symbol a : letters) {
        State further(width_, 0);
        for (std::size_t block = 0; block < width_; ++block)
            for (std::uint64_t bits = row[block]; bits != 0; bits &= bits - 1) {
                const std::size_t begin =
                    at(a, block * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
                for (std::size_t k = 0; k < width_; ++k) further[k] |= rows[begin + k];
            }
        row = std::move(further);
    }
    return row;
}

}  // namespace algae
