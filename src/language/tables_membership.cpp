#include "language/language.hpp"

#include <algorithm>
#include <bit>
#include <boost/container_hash/hash.hpp>

#include "exact/exact.hpp"
#include "language/detail/letters.hpp"
#include "language/detail/regular.hpp"
#include "system/system.hpp"

// What ET0L systems have in common with regular languages: membership, meetings, emptiness, and shortest derivations.
//
// The question: does L(G) have a word that an automaton accepts? Membership is the case of the automaton of one
// word, emptiness that of all words over the terminals. For every sequence of tables and every letter take the
// pairs of states between which some word leads that the letter derives by these tables. Those of a sequence
// without its first table give those of the sequence by one product of relations a rule, so `walk_of_tables`
// finds all families of relations, shortest sequences first, until one accepts from the axiom or nothing new
// comes; there are finitely many. Relations are rows of bits; states from which nothing is accepted are left
// out first.
//
// A derivation is worked out afterwards: by the tables found, backwards, the least length of a word between two
// states for each letter, then forwards a choice of successors with these lengths. What leaves no letter in the
// last word is erased as soon as the tables can, otherwise words of length 0 could be derived for ever.
//
// With one table and only terminals the 0L decision of membership.cpp is used: it needs no automaton.

namespace algae {

namespace {

/// The states of a deterministic automaton from which something is accepted, numbered anew: a
/// letter leads from one to another or nowhere.
struct UsefulStates {
    static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

    std::size_t letters = 0;
    std::size_t initial = nowhere;  // nowhere if nothing is accepted
    std::vector<char> accepting;
    std::vector<std::size_t> transitions;

    std::size_t states() const { return accepting.size(); }
    std::size_t step(std::size_t state, Symbol letter) const {
        return transitions[state * letters + letter];
    }
};

/// Of an automaton over at least `letters` letters; it refuses those that it does not know.
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

/// The system whose L(G) is asked about, and what words derived from its letters do to the states
/// of an automaton. A state of the walk is, for every accessible letter and every state of the
/// automaton, a row of bits: the states to which some word leads that the letter derives by a given
/// sequence of tables. The rows of a sequence are found from those of the sequence without its
/// first table. System and automaton must outlive it.
class Relations {
public:
    using State = std::vector<std::uint64_t>;

    Relations(const ET0L& system, const UsefulStates& automaton)
        : system_(&system),
          automaton_(&automaton),
          letters_(accessible_letters(system)),
          place_(system.alphabet->size(), 0),
          width_((automaton.states() + 63) / 64) {
        for (std::size_t i = 0; i < letters_.size(); ++i) place_[letters_[i]] = i;
    }

    State first() const {
        State rows(letters_.size() * automaton_->states() * width_, 0);
        for (const Symbol a : letters_)
            for (std::size_t s = 0; s < automaton_->states(); ++s)
                if (const std::size_t to = automaton_->step(s, a); to != UsefulStates::nowhere)
                    rows[at(a, s) + to / 64] |= std::uint64_t{1} << (to % 64);
        return rows;
    }

    /// O(states^2 * states / 64 * size of the table).
    State next(const State& rows, std::uint32_t table) const {
        State following(rows.size(), 0);
        for (const Symbol a : letters_)
            for (std::size_t s = 0; s < automaton_->states(); ++s)
                for (const Word& successor : system_->tables[table][a]) {
                    const State row = reached(rows, s, successor);
                    for (std::size_t k = 0; k < width_; ++k) following[at(a, s) + k] |= row[k];
                }
        return following;
    }

    /// Whether the axiom derives an accepted word.
    bool stops(const State& rows) const {
        if (automaton_->initial == UsefulStates::nowhere) return false;
        const State row = reached(rows, automaton_->initial, system_->axiom);
        for (std::size_t s = 0; s < automaton_->states(); ++s)
            if (automaton_->accepting[s] && (row[s / 64] >> (s % 64) & 1) != 0) return true;
        return false;
    }
    std::uint64_t bytes(const State& rows) const { return rows.size() * sizeof(std::uint64_t); }

    std::size_t hash(const State& rows) const {
        return boost::hash_range(rows.begin(), rows.end());
    }

private:
    std::size_t at(Symbol a, std::size_t state) const {
        return (place_[a] * automaton_->states() + state) * width_;
    }

    State reached(const State& rows, std::size_t from, const Word& letters) const {
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

    const ET0L* system_;
    const UsefulStates* automaton_;
    std::vector<Symbol> letters_;
    std::vector<std::size_t> place_;  // by symbol: its place in letters_
    std::size_t width_;               // of a row, in words of 64 bits
};

/// For every letter and two states the least length of a word derived from the letter that leads
/// from one to the other; lengths above a bound count as infinite.
class Lengths {
public:
    using Table = std::vector<std::uint64_t>;

    Lengths(const ET0L& system, const UsefulStates& automaton, std::uint64_t bound)
        : system_(&system),
          automaton_(&automaton),
          letters_(accessible_letters(system)),
          place_(system.alphabet->size(), 0),
          infinite_(bound + 1) {
        for (std::size_t i = 0; i < letters_.size(); ++i) place_[letters_[i]] = i;
    }

    std::uint64_t bytes() const {
        return letters_.size() * automaton_->states() * automaton_->states() *
               sizeof(std::uint64_t);
    }
    std::uint64_t infinite() const { return infinite_; }

    Table first() const {
        Table lengths(static_cast<std::size_t>(bytes() / sizeof(std::uint64_t)), infinite_);
        for (const Symbol a : letters_)
            for (std::size_t s = 0; s < automaton_->states(); ++s)
                if (const std::size_t to = automaton_->step(s, a); to != UsefulStates::nowhere)
                    lengths[at(a, s, to)] = 1;
        return lengths;
    }

    Table next(const Table& lengths, std::uint32_t table) const {
        Table following(lengths.size(), infinite_);
        for (const Symbol a : letters_)
            for (std::size_t s = 0; s < automaton_->states(); ++s)
                for (const Word& successor : system_->tables[table][a]) {
                    const auto reached = stages(lengths, s, successor).back();
                    for (std::size_t t = 0; t < automaton_->states(); ++t)
                        following[at(a, s, t)] = std::min(following[at(a, s, t)], reached[t]);
                }
        return following;
    }

    std::uint64_t of(const Table& lengths, Symbol a, std::size_t from, std::size_t to) const {
        return lengths[at(a, from, to)];
    }

    /// After each of the letters, by state: the least length of a word that leads there.
    std::vector<Table> stages(const Table& lengths, std::size_t from, const Word& letters) const {
        std::vector<Table> found{Table(automaton_->states(), infinite_)};
        found[0][from] = 0;
        for (const Symbol a : letters) {
            Table further(automaton_->states(), infinite_);
            for (std::size_t s = 0; s < automaton_->states(); ++s)
                if (found.back()[s] < infinite_)
                    for (std::size_t t = 0; t < automaton_->states(); ++t)
                        further[t] = std::min(further[t], found.back()[s] + lengths[at(a, s, t)]);
            found.push_back(std::move(further));
        }
        return found;
    }

    /// The states between the letters on a way with a shortest word.
    std::vector<std::size_t> way(const Table& lengths, const std::vector<Table>& stages,
                                 const Word& letters, std::size_t to) const {
        std::vector<std::size_t> states(letters.size() + 1, to);
        for (std::size_t i = letters.size(); i-- > 0;) {
            std::size_t s = 0;
            while (stages[i][s] + lengths[at(letters[i], s, states[i + 1])] !=
                   stages[i + 1][states[i + 1]])
                ++s;
            states[i] = s;
        }
        return states;
    }

    /// Lives of no steps: no letter is gone.
    Table first_lives() const { return Table(letters_.size(), infinite_); }

    /// By letter: the least number of steps until it can be gone, from that with a table less.
    Table next_lives(const Table& lives, std::uint32_t table) const {
        Table following = first_lives();
        for (const Symbol a : letters_)
            for (const Word& successor : system_->tables[table][a])
                following[place_[a]] = std::min(following[place_[a]], life(lives, successor));
        return following;
    }

    /// The successor by which the letter is gone soonest.
    std::uint32_t erasing_choice(const Table& lives, std::uint32_t table, Symbol a) const {
        const auto& choices = system_->tables[table][a];
        const auto soonest = std::min_element(choices.begin(), choices.end(),
                                              [&](const Word& left, const Word& right) {
                                                  return life(lives, left) < life(lives, right);
                                              });
        return static_cast<std::uint32_t>(soonest - choices.begin());
    }

private:
    std::size_t at(Symbol a, std::size_t from, std::size_t to) const {
        return (place_[a] * automaton_->states() + from) * automaton_->states() + to;
    }

    std::uint64_t life(const Table& lives, const Word& successor) const {
        std::uint64_t longest = 0;
        for (const Symbol a : successor) longest = std::max(longest, lives[place_[a]]);
        return std::min(longest + 1, infinite_);
    }

    const ET0L* system_;
    const UsefulStates* automaton_;
    std::vector<Symbol> letters_;
    std::vector<std::size_t> place_;
    std::uint64_t infinite_;
};

/// A letter and the states between which the word that comes of it leads.
struct Share {
    Symbol letter;
    std::size_t from, to;
};

void share_out(const Word& letters, const std::vector<std::size_t>& states,
               std::vector<Share>& shares) {
    for (std::size_t i = 0; i < letters.size(); ++i)
        shares.push_back({letters[i], states[i], states[i + 1]});
}

/// A derivation by these tables, one a step, of an accepted word, and of a shortest that they
/// derive. There must be one. What leaves no letter in the last word is erased as soon as the
/// tables can. Time and memory O(steps * letters * states^2), time also times the size of the
/// rules. Throws BoundReached if the tables of lengths take more than budget.memory or the words
/// have more than budget.letters letters together.
Derivation shortest_derivation(const ET0L& system, const UsefulStates& automaton,
                               const std::vector<std::uint32_t>& tables, const Budget& budget) {
    const std::size_t steps = tables.size();
    const auto too_long = [&] {
        return BoundReached(Bound::letters,
                            "generation " + std::to_string(steps) +
                                " is the first with such a word, but a derivation has more than " +
                                std::to_string(budget.letters) + " letters, the bound set" +
                                budget.by(Bound::letters));
    };
    const Lengths lengths(system, automaton, budget.letters);
    budget.check_memory((steps + 1) * lengths.bytes(), "the tables of a derivation");
    // Number `left` is of the last `left` tables.
    std::vector<Lengths::Table> of_last{lengths.first()}, lives{lengths.first_lives()};
    for (std::size_t left = 0; left < steps; ++left) {
        budget.check();
        of_last.push_back(lengths.next(of_last.back(), tables[steps - 1 - left]));
        lives.push_back(lengths.next_lives(lives.back(), tables[steps - 1 - left]));
    }
    const auto ends = lengths.stages(of_last[steps], automaton.initial, system.axiom);
    std::size_t end = automaton.states();
    for (std::size_t s = 0; s < automaton.states(); ++s)
        if (automaton.accepting[s] &&
            (end == automaton.states() || ends.back()[s] < ends.back()[end]))
            end = s;
    if (ends.back()[end] >= lengths.infinite()) throw too_long();
    std::vector<Share> shares;
    share_out(system.axiom, lengths.way(of_last[steps], ends, system.axiom, end), shares);
    Derivation found{{system.axiom}, {}};
    std::uint64_t letters = system.axiom.size();
    for (std::size_t left = steps; left-- > 0;) {
        budget.check();
        const std::uint32_t table = tables[steps - 1 - left];
        std::vector<Share> next;
        std::vector<std::uint32_t> choices;
        for (const Share& share : shares) {
            const auto& successors = system.tables[table][share.letter];
            const std::uint64_t length =
                lengths.of(of_last[left + 1], share.letter, share.from, share.to);
            std::uint32_t choice =
                length == 0 ? lengths.erasing_choice(lives[left], table, share.letter) : 0;
            auto stages = lengths.stages(of_last[left], share.from, successors[choice]);
            while (stages.back()[share.to] != length)
                stages = lengths.stages(of_last[left], share.from, successors[++choice]);
            share_out(successors[choice],
                      lengths.way(of_last[left], stages, successors[choice], share.to), next);
            choices.push_back(choice);
        }
        shares = std::move(next);
        letters += shares.size();
        if (letters > budget.letters) throw too_long();
        found.choices.push_back(std::move(choices));
        found.words.emplace_back();
        for (const Share& share : shares) found.words.back().push_back(share.letter);
    }
    if (system.tables.size() > 1) found.tables = tables;
    return found;
}

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

bool is_derivation(const OL& system, const Derivation& derivation) {
    return is_derivation(as_et0l(system), derivation);
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
