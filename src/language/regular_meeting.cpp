#include "language/regular_meeting.hpp"

#include <algorithm>
#include <bit>

#include "base/error.hpp"
#include "language/finiteness_letters.hpp"

namespace algae {

namespace {

/// For every letter and state a row of bits: the states that some word leads to.
class Relations {
public:
    using Table = std::vector<std::uint64_t>;

    Relations(const OL& system, const Dfa& automaton)
        : system_(&system), automaton_(&automaton), width_((automaton.states() + 63) / 64) {}

    std::uint64_t bytes() const { return system_->alphabet->size() * automaton_->states() * width_ * sizeof(std::uint64_t); }

    Table first() const {
        Table table(bytes() / sizeof(std::uint64_t), 0);
        for (const Symbol a : system_->letters)
            for (std::size_t s = 0; s < automaton_->states(); ++s) {
                const std::size_t to = automaton_->step(s, a);
                table[at(a, s) + to / 64] |= std::uint64_t{1} << (to % 64);
            }
        return table;
    }

    Table next(const Table& table) const {
        Table following(table.size(), 0);
        for (const Symbol a : system_->letters)
            for (std::size_t s = 0; s < automaton_->states(); ++s)
                for (const Word& successor : system_->successors[a]) {
                    const Table row = reached(table, s, successor);
                    for (std::size_t k = 0; k < width_; ++k) following[at(a, s) + k] |= row[k];
                }
        return following;
    }

    bool accepts(const Table& table) const {
        const Table row = reached(table, automaton_->initial, system_->axiom);
        for (std::size_t s = 0; s < automaton_->states(); ++s)
            if (automaton_->accepting[s] && (row[s / 64] >> (s % 64) & 1) != 0) return true;
        return false;
    }

private:
    std::size_t at(Symbol a, std::size_t state) const { return (a * automaton_->states() + state) * width_; }

    Table reached(const Table& table, std::size_t from, const Word& letters) const {
        Table row(width_, 0);
        row[from / 64] = std::uint64_t{1} << (from % 64);
        for (const Symbol a : letters) {
            Table further(width_, 0);
            for (std::size_t block = 0; block < width_; ++block)
                for (std::uint64_t bits = row[block]; bits != 0; bits &= bits - 1) {
                    const std::size_t begin = at(a, block * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
                    for (std::size_t k = 0; k < width_; ++k) further[k] |= table[begin + k];
                }
            row = std::move(further);
        }
        return row;
    }

    const OL* system_;
    const Dfa* automaton_;
    std::size_t width_;
};

/// For every letter and two states the least length of a word derived from the letter that leads from
/// one to the other; lengths above a bound count as infinite.
class Lengths {
public:
    using Table = std::vector<std::uint64_t>;

    Lengths(const OL& system, const Dfa& automaton, std::uint64_t bound)
        : system_(&system), automaton_(&automaton), infinite_(bound + 1) {}

    std::uint64_t bytes() const { return system_->alphabet->size() * automaton_->states() * automaton_->states() * sizeof(std::uint64_t); }
    std::uint64_t infinite() const { return infinite_; }

    Table first() const {
        Table table(bytes() / sizeof(std::uint64_t), infinite_);
        for (const Symbol a : system_->letters)
            for (std::size_t s = 0; s < automaton_->states(); ++s) table[at(a, s, automaton_->step(s, a))] = 1;
        return table;
    }

    Table next(const Table& table) const {
        Table following(table.size(), infinite_);
        for (const Symbol a : system_->letters)
            for (std::size_t s = 0; s < automaton_->states(); ++s)
                for (const Word& successor : system_->successors[a]) {
                    const auto reached = stages(table, s, successor).back();
                    for (std::size_t t = 0; t < automaton_->states(); ++t)
                        following[at(a, s, t)] = std::min(following[at(a, s, t)], reached[t]);
                }
        return following;
    }

    std::uint64_t of(const Table& table, Symbol a, std::size_t from, std::size_t to) const { return table[at(a, from, to)]; }

    /// After each of the letters, by state: the least length of a word that leads there.
    std::vector<Table> stages(const Table& table, std::size_t from, const Word& letters) const {
        std::vector<Table> found{Table(automaton_->states(), infinite_)};
        found[0][from] = 0;
        for (const Symbol a : letters) {
            Table further(automaton_->states(), infinite_);
            for (std::size_t s = 0; s < automaton_->states(); ++s)
                if (found.back()[s] < infinite_)
                    for (std::size_t t = 0; t < automaton_->states(); ++t)
                        further[t] = std::min(further[t], found.back()[s] + table[at(a, s, t)]);
            found.push_back(std::move(further));
        }
        return found;
    }

    /// The states between the letters on a way with a shortest word.
    std::vector<std::size_t> way(const Table& table, const std::vector<Table>& stages, const Word& letters, std::size_t to) const {
        std::vector<std::size_t> states(letters.size() + 1, to);
        for (std::size_t i = letters.size(); i-- > 0;) {
            std::size_t s = 0;
            while (stages[i][s] + table[at(letters[i], s, states[i + 1])] != stages[i + 1][states[i + 1]]) ++s;
            states[i] = s;
        }
        return states;
    }

private:
    std::size_t at(Symbol a, std::size_t from, std::size_t to) const {
        return (a * automaton_->states() + from) * automaton_->states() + to;
    }

    const OL* system_;
    const Dfa* automaton_;
    std::uint64_t infinite_;
};

/// A letter and the states between which the word that comes of it leads.
struct Share {
    Symbol letter;
    std::size_t from, to;
};

void share_out(const Word& letters, const std::vector<std::size_t>& states, std::vector<Share>& shares) {
    for (std::size_t i = 0; i < letters.size(); ++i) shares.push_back({letters[i], states[i], states[i + 1]});
}

/// The derivation of a shortest accepted word of the generation, which has one.
Derivation shortest_derivation(const OL& system, const Dfa& automaton, std::uint64_t step, const Budget& budget) {
    const auto too_long = [&] {
        return BoundReached("generation " + std::to_string(step) + " is the first with such a word, but a derivation has more than " +
                            std::to_string(budget.letters) + " letters, the bound set by --max-letters");
    };
    const Lengths lengths(system, automaton, budget.letters);
    budget.check_memory((step + 1) * lengths.bytes(), "the tables of a derivation");
    std::vector<Lengths::Table> tables{lengths.first()};
    while (tables.size() <= step) {
        budget.check();
        tables.push_back(lengths.next(tables.back()));
    }
    const LetterFutures futures = letter_futures(system);
    const auto ends = lengths.stages(tables[step], automaton.initial, system.axiom);
    std::size_t end = automaton.states();
    for (std::size_t s = 0; s < automaton.states(); ++s)
        if (automaton.accepting[s] && (end == automaton.states() || ends.back()[s] < ends.back()[end])) end = s;
    if (ends.back()[end] >= lengths.infinite()) throw too_long();
    std::vector<Share> shares;
    share_out(system.axiom, lengths.way(tables[step], ends, system.axiom, end), shares);
    Derivation found{{system.axiom}, {}};
    std::uint64_t letters = system.axiom.size();
    for (std::uint64_t left = step; left-- > 0;) {
        budget.check();
        std::vector<Share> next;
        std::vector<std::uint32_t> choices;
        for (const Share& share : shares) {
            const std::uint64_t length = lengths.of(tables[left + 1], share.letter, share.from, share.to);
            std::uint32_t choice = length == 0 ? erasing_choice(system, futures, share.letter) : 0;
            auto stages = lengths.stages(tables[left], share.from, system.successors[share.letter][choice]);
            while (stages.back()[share.to] != length)
                stages = lengths.stages(tables[left], share.from, system.successors[share.letter][++choice]);
            const Word& successor = system.successors[share.letter][choice];
            share_out(successor, lengths.way(tables[left], stages, successor, share.to), next);
            choices.push_back(choice);
        }
        shares = std::move(next);
        letters += shares.size();
        if (letters > budget.letters) throw too_long();
        found.choices.push_back(std::move(choices));
        found.words.emplace_back();
        for (const Share& share : shares) found.words.back().push_back(share.letter);
    }
    return found;
}

}  // namespace

Meeting first_meeting(const OL& system, const RegularLanguage& language, const Budget& budget) {
    const Dfa automaton = widened(language.automaton(), system.alphabet->size());
    const Relations relations(system, automaton);
    budget.check_memory(3 * relations.bytes(), "the relations of states");
    Relations::Table table = relations.first();
    // Brent 1980: one table is remembered, and a later one each time twice as many have passed.
    Relations::Table remembered = table;
    std::uint64_t remembered_step = 0;
    for (std::uint64_t step = 0, until = 1;; ++step) {
        budget.check();
        if (relations.accepts(table)) return {shortest_derivation(system, automaton, step, budget), step, 0};
        if (step > 0 && table == remembered) return {std::nullopt, step, remembered_step};
        if (step == until) {
            remembered = table;
            remembered_step = step;
            until *= 2;
        }
        table = relations.next(table);
    }
}

Meeting first_outside(const OL& system, const RegularLanguage& language, const Budget& budget) {
    return first_meeting(system, complement(language, system.letters, budget), budget);
}

}  // namespace algae
