#include "language/construct_gsm.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "language/construct_draft.hpp"
#include "language/construct_gsm_deterministic.hpp"
#include "language/construct_image.hpp"
#include "language/construct_synchronised.hpp"

namespace algae {

namespace {

using Relation = std::vector<char>;  // from p to q: at p * states + q

/// For each letter the pairs of states between which some word leads that it derives, if each letter may
/// have tables of its own.
std::vector<Relation> possible_ways(const ET0L& separate, const Gsm& machine,
                                    const Budget& budget) {
    const std::size_t n = machine.states();
    std::vector<Relation> ways(separate.alphabet->size(), Relation(n * n));
    for (const Gsm::Move& move : machine.moves)
        if (separate.terminal.at(move.letter)) ways[move.letter][move.from * n + move.to] = true;
    const auto ways_of = [&](const Word& word) {
        Relation found(n * n);
        for (std::size_t p = 0; p < n; ++p) found[p * n + p] = true;
        for (const Symbol a : word) {
            Relation longer(n * n);
            for (std::size_t p = 0; p < n; ++p)
                for (std::size_t r = 0; r < n; ++r)
                    if (found[p * n + r])
                        for (std::size_t q = 0; q < n; ++q)
                            if (ways[a][r * n + q]) longer[p * n + q] = true;
            found = std::move(longer);
        }
        return found;
    };
    for (bool grown = true; grown;) {
        grown = false;
        budget.check();
        for (const Table& rules : separate.tables)
            for (Symbol a = 0; a < rules.size(); ++a)
                for (const Word& successor : rules[a]) {
                    if (separate.terminal[a]) continue;
                    const Relation more = ways_of(successor);
                    for (std::size_t i = 0; i < n * n; ++i)
                        if (more[i] && !ways[a][i]) ways[a][i] = grown = true;
                }
    }
    return ways;
}

/// Makes triples from the axiom on. A terminal between two states is each of the `names` of the moves there.
class Triples {
public:
    Triples(const ET0L& separate, const Gsm& machine, const std::vector<std::string>& names,
            const Alphabet& base, const Budget& budget)
        : system_(&separate),
          machine_(&machine),
          budget_(&budget),
          ways_(possible_ways(separate, machine, budget)),
          draft_(base, 0) {
        draft_.add_tables(separate);
        for (std::size_t i = 0; i < machine.moves.size(); ++i) {
            const Gsm::Move& move = machine.moves[i];
            if (separate.terminal[move.letter])
                terminals_[{move.from, move.letter, move.to}].push_back(draft_.terminal(names[i]));
        }
    }

    ET0L result() {
        const Symbol start = draft_.fresh("S");
        const Symbol axiom = system_->axiom.front();
        for (std::size_t t = 0; t < system_->tables.size(); ++t)
            for (std::size_t q = 0; q < machine_->states(); ++q)
                if (machine_->accepting[q]) add_rules(t, start, {machine_->initial, axiom, q});
        while (!open_.empty()) {
            const Triple triple = open_.back();
            open_.pop_back();
            for (std::size_t t = 0; t < system_->tables.size(); ++t)
                add_rules(t, letters_.at(triple), triple);
        }
        return draft_.system({start}, "image");
    }

private:
    using Triple = std::array<std::size_t, 3>;  // state, letter, state

    /// A successor with the states from which its letters from each one on may lead to some last state.
    struct Goal {
        const Word* successor;
        std::vector<std::vector<char>> before;
    };

    Goal goal(const Word& successor, std::size_t last) const {
        const std::size_t n = machine_->states();
        Goal found{&successor,
                   std::vector<std::vector<char>>(successor.size() + 1, std::vector<char>(n))};
        found.before.back()[last] = true;
        for (std::size_t i = successor.size(); i-- > 0;)
            for (std::size_t p = 0; p < n; ++p)
                for (std::size_t q = 0; q < n; ++q)
                    if (found.before[i + 1][q] && ways_[successor[i]][p * n + q])
                        found.before[i][p] = true;
        return found;
    }

    void add_rules(std::size_t table, Symbol letter, const Triple& triple) {
        for (const Word& successor : system_->tables[table][triple[1]]) {
            const Goal whole = goal(successor, triple[2]);
            if (whole.before.front()[triple[0]]) guess(table, letter, whole, {}, triple[0]);
        }
    }

    /// All ways from `state` on through the letters that `begun` does not have yet.
    void guess(std::size_t table, Symbol letter, const Goal& goal, Word begun, std::size_t state) {
        const std::size_t place = begun.size();
        if (place == goal.successor->size()) {
            draft_.add_rule(table, letter, std::move(begun));
            draft_.check(*budget_);
            return;
        }
        const Symbol a = (*goal.successor)[place];
        begun.push_back(0);
        for (std::size_t next = 0; next < machine_->states(); ++next) {
            if (!goal.before[place + 1][next] || !ways_[a][state * machine_->states() + next])
                continue;
            for (const Symbol found : between({state, a, next})) {
                begun.back() = found;
                guess(table, letter, goal, begun, next);
            }
        }
    }

    /// The letters of the result for a letter between two states.
    std::vector<Symbol> between(const Triple& triple) {
        const auto a = static_cast<Symbol>(triple[1]);
        if (system_->terminal[a]) return terminals_.at(triple);
        const auto [place, fresh] = letters_.try_emplace(triple, 0);
        if (fresh) {
            place->second = draft_.fresh(system_->alphabet->name(a));
            open_.push_back(triple);
        }
        return {place->second};
    }

    const ET0L* system_;
    const Gsm* machine_;
    const Budget* budget_;
    std::vector<Relation> ways_;
    Draft draft_;
    std::map<Triple, std::vector<Symbol>> terminals_;
    std::map<Triple, Symbol> letters_;
    std::vector<Triple> open_;
};

/// The machine without moves for letters that the system does not have.
Gsm within(const ET0L& system, Gsm machine) {
    std::erase_if(machine.moves,
                  [&](const Gsm::Move& move) { return move.letter >= system.alphabet->size(); });
    return machine;
}

Gsm copying_within(const ET0L& system, const RegularLanguage& language) {
    return within(system, copying(language.automaton()));
}

/// The sequences of moves over words of L(G), each move a letter with a new name, and what moves write.
struct Runs {
    ET0L system;
    Substitution written;
};

Runs runs(const ET0L& system, const Gsm& machine, const Budget& budget) {
    Alphabet alphabet = *system.alphabet;
    NewNames fresh(alphabet);
    Runs found;
    std::vector<std::string> names;
    for (const Gsm::Move& move : machine.moves) {
        const Symbol letter = fresh.symbol(system.alphabet->name(move.letter));
        names.push_back(alphabet.name(letter));
        found.written[letter] = {move.output};
    }
    found.system = Triples(synchronised(system), machine, names, alphabet, budget).result();
    return found;
}

}  // namespace

ET0L e0l_gsm_image(const ET0L& system, const Gsm& machine, const Budget& budget) {
    const Runs found = runs(system, within(system, machine), budget);
    return trimmed(e0l_image(found.system, found.written, budget), *system.alphabet, "image");
}

ET0L e0l_intersection(const ET0L& system, const RegularLanguage& language, const Budget& budget) {
    const Gsm machine = copying_within(system, language);
    std::vector<std::string> names;
    for (const Gsm::Move& move : machine.moves) names.push_back(system.alphabet->name(move.letter));
    ET0L found = Triples(synchronised(system), machine, names, *system.alphabet, budget).result();
    found.name = "intersection";
    return found;
}

ET0L table_gsm_image(const ET0L& system, const Gsm& machine, const Budget& budget) {
    if (is_deterministic(system) && is_deterministic(machine))
        return deterministic_gsm_image(system, within(system, machine), budget);
    const Runs found = runs(system, within(system, machine), budget);
    return trimmed(table_image(found.system, found.written), *system.alphabet, "image");
}

ET0L table_intersection(const ET0L& system, const RegularLanguage& language, const Budget& budget) {
    if (!is_deterministic(system)) return e0l_intersection(system, language, budget);
    ET0L found = deterministic_gsm_image(system, copying_within(system, language), budget);
    found.name = "intersection";
    return found;
}

}  // namespace algae
