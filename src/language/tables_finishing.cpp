#include "language/tables_finishing.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace algae {

namespace {

/// The letters, of these, with a successor of which all letters are in the set.
std::vector<char> letters_before(const FinishingSets& found, std::size_t set, const Table& table,
                                 const std::vector<Symbol>& letters) {
    std::vector<char> before(table.size(), 0);
    for (const Symbol a : letters)
        before[a] = std::any_of(table[a].begin(), table[a].end(), [&](const Word& successor) {
            return found.finishes(set, successor);
        });
    return before;
}

void mark_accessible(const ET0L& system, FinishingSets& found) {
    found.accessible.assign(found.sets.size(), std::vector<char>(system.terminal.size(), 0));
    std::vector<std::pair<std::size_t, Symbol>> queue;
    const auto see = [&](std::size_t set, const Word& word) {
        if (!found.finishes(set, word)) return;
        for (const Symbol a : word)
            if (!found.accessible[set][a]) {
                found.accessible[set][a] = 1;
                queue.emplace_back(set, a);
            }
    };
    for (std::size_t set = 0; set < found.sets.size(); ++set) see(set, system.axiom);
    for (std::size_t i = 0; i < queue.size(); ++i) {
        const auto [set, a] = queue[i];
        for (const auto& [table, to] : found.steps[set])
            for (const Word& successor : system.tables[table][a]) see(to, successor);
    }
}

}  // namespace

bool FinishingSets::finishes(std::size_t set, const Word& word) const {
    return std::all_of(word.begin(), word.end(), [&](Symbol a) { return sets[set][a] != 0; });
}

FinishingSets finishing_sets(const ET0L& system, const Budget& budget) {
    const std::vector<Symbol> letters = accessible_letters(system);
    FinishingSets found{{std::vector<char>(system.terminal.size(), 0)}, {}, {}, {}};
    for (const Symbol a : letters) found.sets[0][a] = system.terminal[a];
    std::map<std::vector<char>, std::size_t> known{{found.sets[0], 0}};
    const std::uint64_t bytes =
        3 * system.terminal.size() + 2 * system.tables.size() * sizeof(FinishingSets::Step) + 256;
    for (std::size_t set = 0; set < found.sets.size(); ++set) {
        found.before.emplace_back();
        for (const Table& table : system.tables) {
            budget.check();
            std::vector<char> before = letters_before(found, set, table, letters);
            const auto [at, is_new] = known.try_emplace(before, found.sets.size());
            if (is_new) found.sets.push_back(std::move(before));
            found.before[set].push_back(at->second);
        }
        budget.check_memory(found.sets.size() * bytes,
                            "the sets of letters that can become terminals");
    }
    found.steps.resize(found.sets.size());
    for (std::size_t set = 0; set < found.sets.size(); ++set)
        for (std::uint32_t table = 0; table < system.tables.size(); ++table)
            found.steps[found.before[set][table]].push_back({table, set});
    mark_accessible(system, found);
    return found;
}

}  // namespace algae
