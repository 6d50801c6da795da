#include "language/construct_substitution.hpp"

#include <vector>

#include "base/error.hpp"
#include "language/construct_draft.hpp"

namespace algae {

ET0L substituted(const ET0L& system, const std::map<Symbol, ET0L>& languages) {
    const ET0L useful = trimmed(system, *system.alphabet, system.name);
    for (const Symbol a : accessible_letters(useful))
        if (useful.terminal[a] && !languages.contains(a))
            throw Error("expected a language for every letter, found none for the letter " +
                        useful.alphabet->name(a));

    Draft draft(*system.alphabet, 0);
    const std::size_t outer = draft.add_tables(system), turn = draft.add_table();
    const auto copies = draft.copies(system);
    for (std::size_t t = 0; t < system.tables.size(); ++t)
        draft.add_rules(outer + t, system, t, copies);
    std::vector<Symbol> waiting;
    for (const auto& [a, language] : languages) {
        if (!system.terminal.at(a)) continue;
        waiting.push_back(draft.fresh(system.alphabet->name(a)));
        const auto inner = draft.copies(language);
        draft.add_rule(turn, copies[a], {waiting.back()});
        draft.add_rule(turn, waiting.back(), replaced(language.axiom, inner));
        for (Symbol b = 0; b < inner.size(); ++b)
            if (language.terminal[b])
                draft.add_rule(turn, inner[b], draft.terminals(*language.alphabet, {b}));
        const std::size_t first = draft.add_tables(language);
        for (std::size_t t = 0; t < language.tables.size(); ++t)
            draft.add_rules(first + t, language, t, inner);
    }
    for (const Symbol a : waiting) draft.keep(a);
    draft.keep_terminals();
    return draft.system(replaced(system.axiom, copies), "substitution");
}

}  // namespace algae
