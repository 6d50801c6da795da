#include "language/tables_finiteness.hpp"

#include <algorithm>

#include "language/tables_finishing.hpp"
#include "language/tables_rounds.hpp"

namespace algae {

namespace {

using Letters = std::vector<char>;

bool all_in(const Letters& set, const Word& word) {
    return std::all_of(word.begin(), word.end(), [&](Symbol a) { return set[a] != 0; });
}

/// The accessible letters that finish before each step of the course, and last those after it.
std::vector<Letters> finishing(const ET0L& system, const Course& course, const Letters& last) {
    const std::vector<Symbol> letters = accessible_letters(system);
    std::vector<Letters> sets(course.size() + 1, Letters(last.size(), 0));
    for (const Symbol a : letters) sets.back()[a] = last[a];
    for (std::size_t t = course.size(); t-- > 0;)
        for (const Symbol a : letters) {
            const auto& choices = system.tables[course[t].table][a];
            sets[t][a] = std::any_of(choices.begin(), choices.end(),
                                     [&](const Word& word) { return all_in(sets[t + 1], word); });
        }
    return sets;
}

/// Whether the course goes from one letter to the other, by rules that are there.
bool goes(const ET0L& system, const Course& course, Symbol from, Symbol to) {
    for (const TableUse& use : course) {
        if (use.letter != from || use.table >= system.tables.size()) return false;
        const auto& choices = system.tables[use.table][use.letter];
        if (use.choice >= choices.size() || use.place >= choices[use.choice].size()) return false;
        from = choices[use.choice][use.place];
    }
    return from == to;
}

/// Whether all letters that come of the steps finish.
bool stays(const ET0L& system, const Course& course, const std::vector<Letters>& sets) {
    for (std::size_t t = 0; t < course.size(); ++t)
        if (!all_in(sets[t + 1],
                    system.tables[course[t].table][course[t].letter][course[t].choice]))
            return false;
    return true;
}

bool same_tables(const Course& left, const Course& right) {
    return std::equal(
        left.begin(), left.end(), right.begin(), right.end(),
        [](const TableUse& one, const TableUse& other) { return one.table == other.table; });
}

/// Whether two courses are the same up to a step in which the same successor has both at different
/// places.
bool fork(const Course& left, const Course& right) {
    const auto [one, other] = std::mismatch(left.begin(), left.end(), right.begin(), right.end());
    return one != left.end() && other != right.end() && one->letter == other->letter &&
           one->table == other->table && one->choice == other->choice && one->place != other->place;
}

}  // namespace

bool is_proof(const ET0L& system, const EndlessTables& proof) {
    const std::size_t letters = system.terminal.size();
    if (proof.again >= letters || proof.other >= letters) return false;
    Symbol begin = proof.again, end = proof.other;
    if (!proof.before.empty()) begin = proof.before.front().letter;
    if (!goes(system, proof.before, begin, proof.again) ||
        !goes(system, proof.round, proof.again, proof.again) ||
        !goes(system, proof.beside, proof.again, proof.other) ||
        !goes(system, proof.kept, proof.other, proof.other))
        return false;
    if (!proof.after.empty()) {
        const TableUse& last = proof.after.back();
        if (last.table >= system.tables.size() || last.letter >= letters) return false;
        const auto& choices = system.tables[last.table][last.letter];
        if (last.choice >= choices.size() || last.place >= choices[last.choice].size())
            return false;
        end = choices[last.choice][last.place];
    }
    if (!goes(system, proof.after, proof.other, end) || !system.terminal[end]) return false;
    if (!same_tables(proof.round, proof.beside) || !same_tables(proof.round, proof.kept) ||
        !fork(proof.round, proof.beside))
        return false;
    const auto after = finishing(system, proof.after, system.terminal);
    const auto round = finishing(system, proof.round, after.front());
    const auto before = finishing(system, proof.before, after.front());
    for (std::size_t a = 0; a < letters; ++a)
        if (after.front()[a] && !round.front()[a]) return false;
    return std::count(system.axiom.begin(), system.axiom.end(), begin) > 0 &&
           all_in(before.front(), system.axiom) && stays(system, proof.before, before) &&
           stays(system, proof.round, round) && stays(system, proof.beside, round) &&
           stays(system, proof.kept, round) && stays(system, proof.after, after) &&
           after.front()[proof.other];
}

TablesFiniteness finiteness(const ET0L& system, const Budget& budget) {
    const FinishingSets sets = finishing_sets(system, budget);
    std::optional<EndlessTables> endless = first_round(system, sets, budget);
    return {!endless, std::move(endless)};
}

}  // namespace algae
