#include "language/construct_two_tables.hpp"

#include "language/construct_draft.hpp"

namespace algae {

ET0L with_two_tables(const ET0L& system) {
    const std::size_t count = system.tables.size();
    if (count <= 2) return system;
    Draft draft(*system.alphabet, 0);
    const std::size_t turn = draft.add_table("turn"), rewrite = draft.add_table("rewrite");
    std::vector<std::vector<Symbol>> copies{draft.letters(system)};  // for each table
    while (copies.size() < count) copies.push_back(draft.copies(system));
    for (std::size_t t = 0; t < count; ++t)
        for (Symbol a = 0; a < system.alphabet->size(); ++a) {
            draft.add_rule(turn, copies[t][a], {copies[(t + 1) % count][a]});
            for (const Word& successor : system.tables[t][a])
                draft.add_rule(rewrite, copies[t][a], replaced(successor, copies[0]));
        }
    return draft.system(replaced(system.axiom, copies[0]), system.name);
}

}  // namespace algae
