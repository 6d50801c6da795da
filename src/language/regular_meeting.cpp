#include "language/regular_meeting.hpp"

#include "language/tables_lengths.hpp"
#include "language/tables_relations.hpp"
#include "language/tables_walk.hpp"

namespace algae {

namespace {

/// All words over the accessible terminals.
RegularLanguage terminal_words(const ET0L& system) {
    std::vector<Symbol> terminals;
    for (const Symbol a : accessible_letters(system))
        if (system.terminal[a]) terminals.push_back(a);
    return all_words(terminals);
}

}  // namespace

Meeting first_meeting(const OL& system, const RegularLanguage& language, const Budget& budget) {
    return first_meeting(as_et0l(system), language, budget);
}

Meeting first_meeting(const ET0L& system, const RegularLanguage& language, const Budget& budget) {
    const RegularLanguage wanted = has_only_terminals(system)
                                       ? language
                                       : intersected(language, terminal_words(system), budget);
    const UsefulStates automaton = useful_states(wanted.automaton(), system.alphabet->size());
    Relations relations(system, automaton);
    const TablesWalk walk = walk_of_tables(relations, system.tables.size(), budget);
    Meeting found{std::nullopt, walk.step, walk.earlier, walk.states};
    if (walk.tables)
        found.derivation = shortest_derivation(system, automaton, *walk.tables, budget);
    return found;
}

Meeting first_outside(const OL& system, const RegularLanguage& language, const Budget& budget) {
    return first_outside(as_et0l(system), language, budget);
}

Meeting first_outside(const ET0L& system, const RegularLanguage& language, const Budget& budget) {
    return first_meeting(system, difference(terminal_words(system), language, budget), budget);
}

Meeting first_word(const ET0L& system, const Budget& budget) {
    return first_meeting(system, terminal_words(system), budget);
}

}  // namespace algae
