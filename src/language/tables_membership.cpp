#include "language/tables_membership.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "language/regular_language.hpp"
#include "language/tables_lengths.hpp"
#include "language/tables_relations.hpp"
#include "language/tables_walk.hpp"

namespace algae {

namespace {

/// The automaton of the one word.
UsefulStates places_of(const Word& word, const ET0L& system) {
    return useful_states(finite_set({word}).automaton(), system.alphabet->size());
}

}  // namespace

bool is_derivation(const ET0L& system, const Derivation& derivation) {
    const auto& [words, choices, tables] = derivation;
    if (words.empty() || words.front() != system.axiom || choices.size() + 1 != words.size())
        return false;
    if (tables.size() != (system.tables.size() > 1 ? choices.size() : 0)) return false;
    for (std::size_t t = 0; t < choices.size(); ++t) {
        const std::size_t number = tables.empty() ? 0 : tables[t];
        if (number >= system.tables.size() || choices[t].size() != words[t].size()) return false;
        Word next;
        for (std::size_t i = 0; i < words[t].size(); ++i) {
            const Symbol a = words[t][i];
            if (a >= system.terminal.size()) return false;
            const auto& successors = system.tables[number][a];
            if (choices[t][i] >= successors.size()) return false;
            const Word& successor = successors[choices[t][i]];
            next.insert(next.end(), successor.begin(), successor.end());
        }
        if (next != words[t + 1]) return false;
    }
    return true;
}

Membership membership(const ET0L& system, const Word& word, const Budget& budget) {
    using enum Membership::Reason;
    std::vector<char> known(system.terminal.size(), 0);
    for (const Symbol a : accessible_letters(system)) known[a] = 1;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if (word[i] >= known.size() || !known[word[i]]) return {false, foreign, 0, 0, i};
        if (!system.terminal[word[i]]) return {false, nonterminal, 0, 0, i};
    }
    if (system.tables.size() == 1) return membership(without_terminals(system), word, budget);
    const UsefulStates places = places_of(word, system);
    Relations factors(system, places);
    TablesWalk walk = walk_of_tables(factors, system.tables.size(), budget);
    if (!walk.tables) return {false, exhausted, walk.step, 0, 0, walk.states};
    return {true, derived, walk.step, 0, 0, walk.states, std::move(*walk.tables)};
}

Derivation derivation(const ET0L& system, const Word& word, const Membership& found,
                      const Budget& budget) {
    if (!found.member) throw Error("the word is not in the language");
    if (system.tables.size() == 1)
        return derivation(without_terminals(system), word, found.step, budget);
    return shortest_derivation(system, places_of(word, system), found.tables, budget);
}

OL without_terminals(const ET0L& system) {
    if (system.tables.size() > 1)
        throw Error("the system has " + std::to_string(system.tables.size()) + " tables");
    return {system.alphabet, system.axiom, system.tables.front(), accessible_letters(system),
            system.name};
}

}  // namespace algae
