#include "language/detail/construct.hpp"

#include <array>
#include <limits>
#include <map>
#include <set>

#include "exact/exact.hpp"

// What a generalised sequential machine writes on the words of L(G), with it intersections with regular
// languages and inverse homomorphisms
// (Herman and Rozenberg 1975; Rozenberg and Salomaa 1980, II.1, IV.1 and V.1).
//
// A letter of the result is a letter x between two states p and q: what is derived from it leads the machine
// from p to q. The states between the letters of a successor are guessed, and a terminal becomes what the
// machine writes on a move from p to q. Only triples are made where some word derived from x leads from p to q.
//
// With deterministic tables a table guesses for all letters at once what they will do to the states, and the
// triples check it: all letters x of a word derive the same. What letters do to states after the last tables,
// counted backwards, are finitely many families of functions; each has a copy of each table.
//
// For an inverse homomorphism the machine reads images and writes their letters; letters with an empty image
// are inserted afterwards anywhere, by further tables.

namespace algae {

Gsm copying(const Dfa& automaton) {
    Gsm machine{automaton.initial, automaton.accepting, {}};
    for (std::size_t state = 0; state < automaton.states(); ++state)
        for (Symbol a = 0; a < automaton.letters; ++a)
            machine.moves.push_back({state, a, automaton.step(state, a), {a}});
    return machine;
}

bool is_deterministic(const Gsm& machine) {
    std::set<std::pair<std::size_t, Symbol>> seen;
    for (const Gsm::Move& move : machine.moves)
        if (!seen.emplace(move.from, move.letter).second) return false;
    return true;
}

namespace {

constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

/// Where each state is led by what each letter derives: at letter * states + state.
using Functions = std::vector<std::size_t>;

class DeterministicTriples {
public:
    DeterministicTriples(const ET0L& system, const Gsm& machine, const Budget& budget)
        : system_(&system),
          machine_(&machine),
          budget_(&budget),
          letters_(accessible_letters(system)),
          draft_(*system.alphabet, 0),
          start_(draft_.fresh("S")) {}

    ET0L result() {
        for (const Functions& after : all_functions())
            for (const Table& rules : system_->tables) {
                const std::size_t table = draft_.add_table();
                guesses_.push_back({&rules, &after});
                if (const std::size_t last = led(after, system_->axiom, machine_->initial);
                    last != nowhere && machine_->accepting[last])
                    draft_.add_rule(table, start_,
                                    between(after, system_->axiom, machine_->initial));
            }
        const std::size_t end = draft_.add_table();
        while (!open_.empty()) {
            const Triple triple = open_.back();
            open_.pop_back();
            add_rules(triple);
            if (const auto move = moves_.find({triple[0], triple[1]});
                move != moves_.end() && move->second->to == triple[2])
                draft_.add_rule(end, triples_.at(triple),
                                draft_.terminals(*system_->alphabet, move->second->output));
        }
        return draft_.system({start_}, "image");
    }

private:
    using Triple = std::array<std::size_t, 3>;  // state, letter, state

    /// What words of the letters do after the last tables, for any number of these.
    const std::set<Functions>& all_functions() {
        const std::size_t n = machine_->states();
        Functions last(system_->alphabet->size() * n, nowhere);
        for (const Gsm::Move& move : machine_->moves)
            if (system_->terminal.at(move.letter)) {
                last[move.letter * n + move.from] = move.to;
                moves_[{move.from, move.letter}] = &move;
            }
        functions_ = {last};
        std::vector<Functions> open{last};
        while (!open.empty()) {
            const Functions after = std::move(open.back());
            open.pop_back();
            for (const Table& rules : system_->tables) {
                budget_->check();
                Functions before(after.size(), nowhere);
                for (const Symbol a : letters_)
                    for (std::size_t state = 0; state < n; ++state)
                        before[a * n + state] = led(after, rules[a].front(), state);
                if (functions_.insert(before).second) open.push_back(std::move(before));
                budget_->check_memory(functions_.size() * after.size() * sizeof(std::size_t),
                                      "what letters do to states");
            }
        }
        return functions_;
    }

    std::size_t led(const Functions& functions, const Word& word, std::size_t state) const {
        for (const Symbol a : word) {
            if (state == nowhere) break;
            state = functions[a * machine_->states() + state];
        }
        return state;
    }

    /// The word with the states between its letters; it is known to lead somewhere.
    Word between(const Functions& functions, const Word& word, std::size_t state) {
        Word found;
        for (const Symbol a : word) {
            const std::size_t next = functions[a * machine_->states() + state];
            const Triple triple{state, a, next};
            const auto [place, fresh] = triples_.try_emplace(triple, 0);
            if (fresh) {
                place->second = draft_.fresh(system_->alphabet->name(a));
                open_.push_back(triple);
            }
            found.push_back(place->second);
            state = next;
        }
        return found;
    }

    void add_rules(const Triple& triple) {
        for (std::size_t t = 0; t < guesses_.size(); ++t) {
            const auto& [rules, after] = guesses_[t];
            const Word& successor = (*rules)[triple[1]].front();
            if (led(*after, successor, triple[0]) == triple[2])
                draft_.add_rule(t, triples_.at(triple), between(*after, successor, triple[0]));
        }
        draft_.check(*budget_);
    }

    const ET0L* system_;
    const Gsm* machine_;
    const Budget* budget_;
    std::vector<Symbol> letters_;
    Draft draft_;
    Symbol start_;
    std::set<Functions> functions_;
    std::vector<std::pair<const Table*, const Functions*>> guesses_;  // by table of the result
    std::map<std::pair<std::size_t, std::size_t>, const Gsm::Move*> moves_;
    std::map<Triple, Symbol> triples_;
    std::vector<Triple> open_;
};

/// What a deterministic machine writes when it reads words of a deterministic system, by a deterministic system.
ET0L deterministic_gsm_image(const ET0L& system, const Gsm& machine, const Budget& budget) {
    if (!is_deterministic(system))
        throw Error("expected one successor of each letter in each table, found several");
    if (!is_deterministic(machine))
        throw Error("expected one move for each state and letter, found several");
    return DeterministicTriples(system, machine, budget).result();
}

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

namespace {

/// Reads the images of letters after each other and writes the letters.
Gsm decoder(const Morphism& morphism) {
    Gsm machine{0, {1}, {}};
    for (const Symbol letter : morphism.domain()) {
        const Word& image = morphism[letter];
        std::size_t state = 0;
        for (std::size_t i = 0; i < image.size(); ++i) {
            const bool end = i + 1 == image.size();
            if (!end) machine.accepting.push_back(0);
            const std::size_t next = end ? 0 : machine.states() - 1;
            machine.moves.push_back({state, image[i], next, end ? Word{letter} : Word{}});
            state = next;
        }
    }
    return machine;
}

/// The words of the system with any of these letters inserted anywhere: a table makes waiting letters of
/// terminals, another lets inserted letters come before them, and before a mark at the right end.
ET0L inserted(const ET0L& system, const Word& letters) {
    Draft draft(*system.alphabet, 0);
    draft.add_tables(system);
    const auto copies = draft.copies(system);
    const Symbol mark = draft.fresh("R");
    Word axiom = replaced(system.axiom, copies);
    axiom.push_back(mark);
    for (std::size_t t = 0; t < system.tables.size(); ++t) {
        draft.add_rules(t, system, t, copies);
        draft.add_rule(t, mark, {mark});
    }
    const std::size_t wait = draft.add_table(), insert = draft.add_table(), end = draft.add_table();
    const auto add_insertions = [&](Symbol letter) {
        draft.add_rule(insert, letter, {letter});
        for (const Symbol a : draft.terminals(*system.alphabet, letters))
            draft.add_rule(insert, letter, {a, letter});
    };
    draft.add_rule(wait, mark, {mark});
    draft.add_rule(end, mark, {});
    add_insertions(mark);
    for (Symbol a = 0; a < copies.size(); ++a) {
        if (!system.terminal[a]) continue;
        const Symbol waiting = draft.fresh(system.alphabet->name(a));
        draft.add_rule(wait, copies[a], {waiting});
        draft.add_rule(end, waiting, draft.terminals(*system.alphabet, {a}));
        add_insertions(waiting);
    }
    for (const Symbol a : draft.terminals(*system.alphabet, letters)) {
        draft.add_rule(insert, a, {a});
        draft.add_rule(end, a, {a});
    }
    return draft.system(axiom, "inverse image");
}

}  // namespace

ET0L table_inverse_image(const ET0L& system, const Morphism& morphism, const Budget& budget) {
    ET0L result = table_gsm_image(system, decoder(morphism), budget);
    if (const Word erased = morphism.erased(); !erased.empty())
        result = trimmed(inserted(result, erased), *system.alphabet, "");
    result.name = "inverse image";
    return result;
}

}  // namespace algae
