#include "language/tables_lengths.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"

namespace algae {

namespace {

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

}  // namespace

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

}  // namespace algae
