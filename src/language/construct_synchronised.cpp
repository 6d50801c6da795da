#include "language/construct_synchronised.hpp"

#include "language/construct_draft.hpp"

namespace algae {

ET0L synchronised(const ET0L& system) {
    Draft draft(*system.alphabet, 0);
    draft.add_tables(system);
    const auto copies = draft.copies(system), letters = draft.letters(system);
    const Symbol start = draft.fresh("S");
    for (std::size_t t = 0; t < system.tables.size(); ++t) {
        const auto add = [&](Symbol letter, const Word& successor) {
            draft.add_rule(t, letter, replaced(successor, copies));
            if (is_terminal_word(system, successor))
                draft.add_rule(t, letter, replaced(successor, letters));
        };
        add(start, system.axiom);
        for (Symbol a = 0; a < copies.size(); ++a)
            for (const Word& successor : system.tables[t][a]) add(copies[a], successor);
    }
    return draft.system({start}, system.name);
}

}  // namespace algae
