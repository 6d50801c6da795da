#pragma once

// What letters can become: those of 0L systems that last or grow, those that can still finish, the walk through what
// sequences of tables do, and whether a language meets a regular one.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "language/detail/regular.hpp"
#include "language/language.hpp"
#include "system/system.hpp"

namespace algae {

/// What a word becomes in one step by these images, by symbol. Throws BoundReached if it has more letters than the
/// budget allows.
Word generation_after(const std::vector<Word>& images, const Word& word, const Budget& budget);

/// What can become of each letter of an 0L system. All by symbol; letters that are not accessible
/// are left as they begin here.
struct LetterFutures {
    /// Whether some derivation from the letter goes on for ever without becoming empty. The others
    /// are gone after at most as many steps as there are letters, whatever is chosen.
    std::vector<char> lasting;
    /// The least number of steps in which the letter can become the empty word, if it can.
    std::vector<std::optional<std::uint64_t>> shortest_life;
    /// Whether the letter derives words of any length.
    std::vector<char> growing;
    /// Strongly connected lasting letters have the same number; 0 for letters that do not last.
    std::vector<std::size_t> component;
};

/// By fixed points and the strongly connected components of the lasting letters. Time O(size of the
/// rules * number of letters), linear for the components.
///
/// Example: letter_futures(ol("a", {{'a', "ab"}, {'b', ""}})).lasting == std::vector<char>{1, 0}
LetterFutures letter_futures(const OL& system);

/// Rule `choice` of `letter` has its component again and another lasting letter, at these places.
struct Pump {
    Symbol letter = 0;
    std::size_t choice = 0;
    std::size_t again = 0;
    std::size_t other = 0;
    bool operator==(const Pump&) const = default;
};

/// The first rule that pumps, in the order of `OL::letters` and of their successors; none if there
/// is no such rule.
std::optional<Pump> first_pump(const OL& system, const LetterFutures& futures);

/// The rule by which a letter that can become the empty word does so soonest. Throws Error if it cannot.
std::uint32_t erasing_choice(const OL& system, const LetterFutures& futures, Symbol letter);

/// What letters can still do on the way to a word of L(G). A letter finishes by a sequence of tables if it
/// derives a word of terminals by it, perhaps the empty one. The set of letters that finish goes backwards from
/// the terminals: those that do by a table before the sequence have a successor in it whose letters do by the
/// sequence.
///
/// A stage is a letter and such a set that it belongs to. By a table a stage becomes each letter of
/// a successor all of whose letters finish. A stage counts if some way from the axiom, all of whose
/// letters finish, comes by.
struct FinishingSets {
    /// A step forwards: by a table to a set.
    struct Step {
        std::uint32_t table = 0;
        std::size_t to = 0;
    };

    /// Of accessible letters, by symbol; the first is that of no tables: the terminals.
    std::vector<std::vector<char>> sets;
    std::vector<std::vector<Step>> steps;  // from each set
    /// Before[set][table]: the set whose step by the table leads here.
    std::vector<std::vector<std::size_t>> before;
    std::vector<std::vector<char>> accessible;  // by set and symbol: whether the stage counts

    /// Whether all letters of the word finish by the tables that the set is of.
    bool finishes(std::size_t set, const Word& word) const;
};

/// By backward reachability: at most 2^letters sets, one where every letter is a terminal. Throws
/// BoundReached if they take more than budget.memory.
///
/// Example: finishing_sets(et0l("S", {{{'S', "a"}, {'a', "S"}}}, "a")).sets.size() == 2
FinishingSets finishing_sets(const ET0L& system, const Budget& budget = {});

/// Notices that the states of a process repeat, with one of them kept: a later one each time twice as many have passed
/// (Brent 1980), so in less than 3 times the least number of steps.
template <class State>
class Repetitions {
public:
    explicit Repetitions(State first) : kept_(std::move(first)) {}

    /// Whether the state of this step is that of `earlier()`. To be asked at each step from 0 on.
    bool comes_again(const State& state, std::uint64_t step) {
        if (step > 0 && state == kept_) return true;
        if (step == next_) {
            kept_ = state;
            earlier_ = step;
            next_ *= 2;
        }
        return false;
    }
    std::uint64_t earlier() const { return earlier_; }

private:
    State kept_;
    std::uint64_t earlier_ = 0;
    std::uint64_t next_ = 1;  // the step whose state is kept next
};

/// A walk through the states that sequences of tables make.
struct TablesWalk {
    /// By which tables, first step first, where the walk stopped at a state; otherwise nothing.
    std::optional<std::vector<std::uint32_t>> tables;
    /// Where it stopped: the number of steps. Where it did not: with one table the state of `step`
    /// is that of `earlier`; with several no sequence of `step` tables makes a state that shorter
    /// ones do not.
    std::uint64_t step = 0;
    std::uint64_t earlier = 0;
    std::uint64_t states = 0;  // how many different ones were looked at, none with one table twice
};

namespace tables_walk {

template <class Process>
TablesWalk by_one_table(Process& process, const Budget& budget) {
    typename Process::State state = process.first();
    Repetitions repetitions(state);
    budget.check_memory(3 * process.bytes(state), "what the letters derive");
    for (std::uint64_t step = 0;; ++step) {
        budget.check();
        if (repetitions.comes_again(state, step))
            return {std::nullopt, step, repetitions.earlier(), step};
        if (process.stops(state)) {
            budget.check_memory(step * sizeof(std::uint32_t), "the tables of a derivation");
            return {std::vector<std::uint32_t>(static_cast<std::size_t>(step), 0), step, 0,
                    step + 1};
        }
        state = process.next(state, 0);
    }
}

template <class Process>
TablesWalk by_several_tables(Process& process, std::size_t tables, const Budget& budget) {
    using State = typename Process::State;
    struct Found {
        const State* state;  // a key of the map, which does not move
        std::size_t rest;    // the state that it was made of, by
        std::uint32_t table;
        std::uint64_t steps;
    };
    struct Hash {
        const Process* process;
        std::size_t operator()(const State& state) const { return process->hash(state); }
    };
    std::unordered_map<State, std::size_t, Hash> known(16, Hash{&process});
    std::vector<Found> found;
    std::uint64_t bytes = 0;
    const auto is_last = [&](State state, Found how) {
        const auto [at, is_new] = known.try_emplace(std::move(state), found.size());
        if (!is_new) return false;
        bytes += process.bytes(at->first) + sizeof(Found) + sizeof(*at) + 4 * sizeof(void*);
        budget.check_memory(bytes, "what the letters derive by all sequences of tables");
        how.state = &at->first;
        found.push_back(how);
        return process.stops(at->first);
    };
    bool stopped = is_last(process.first(), {nullptr, 0, 0, 0});
    for (std::size_t i = 0; !stopped && i < found.size(); ++i)
        for (std::uint32_t table = 0; !stopped && table < tables; ++table) {
            budget.check();
            stopped = is_last(process.next(*found[i].state, table),
                              {nullptr, i, table, found[i].steps + 1});
        }
    const std::uint64_t steps = found.back().steps;
    if (!stopped) return {std::nullopt, steps + 1, 0, found.size()};
    std::vector<std::uint32_t> by;
    for (std::size_t at = found.size() - 1; at != 0; at = found[at].rest)
        by.push_back(found[at].table);
    return {std::move(by), steps, 0, found.size()};
}

}  // namespace tables_walk

/// What a sequence of tables does is known from its first table and what the rest does: the states
/// of all sequences are found from that of no step, shortest sequences first, until one is to be
/// stopped at or nothing new comes. With one table three states are kept (Brent 1980), with several
/// all.
///
/// `Process` has a type State, State first(), State next(state, table), bool stops(state),
/// std::uint64_t bytes(state) and std::size_t hash(state). Throws what budget.check throws, and
/// BoundReached if the states take more than budget.memory.
template <class Process>
TablesWalk walk_of_tables(Process& process, std::size_t tables, const Budget& budget) {
    return tables == 1 ? tables_walk::by_one_table(process, budget)
                       : tables_walk::by_several_tables(process, tables, budget);
}

/// Whether some word of L(G) is in a regular language, and how that is known.
struct Meeting {
    /// A derivation of such a word, of one in the first generation that has any; with one table of
    /// a shortest there, with several of a shortest by the same tables.
    std::optional<Derivation> derivation;
    /// With a derivation: its number of steps. Without: with one table what words derived from the
    /// letters in `step` steps do to the states of the automaton is what those of `earlier` steps
    /// do, so no later generation has a word that those before have not the like of; with several
    /// tables what they do by any `step` of them is what they do by fewer.
    std::uint64_t step = 0;
    std::uint64_t earlier = 0;
    /// How many families of relations between states were looked at.
    std::uint64_t states = 0;
};

/// Decided, in time O(states^3 / 64 * size of the rules) for each family of relations between states; with one
/// table they are few for most systems, with several tables there can be exponentially many, which are kept.
/// Throws what budget.check throws, and BoundReached if these or the derivation take more than budget.memory or
/// its words have more than budget.letters letters together.
///
/// Example: first_meeting(ol("a", {{'a', "aa"}}), finite_set({{0, 0, 0}, {0, 0, 0, 0}})).step == 2
Meeting first_meeting(const OL& system, const RegularLanguage& language, const Budget& budget = {});

/// Example: first_meeting(et0l("a", {{{'a', "aa"}}, {{'a', "b"}}}), finite_set({{1, 1}})).step == 2
Meeting first_meeting(const ET0L& system, const RegularLanguage& language,
                      const Budget& budget = {});

/// Whether L(G) is contained in a regular language: nothing is derived then, otherwise the
/// derivation of a word outside.
///
/// Example: !first_outside(ol("a", {{'a', "aa"}}), all_words({0})).derivation
Meeting first_outside(const OL& system, const RegularLanguage& language, const Budget& budget = {});

/// Example: !first_outside(et0l("S", {{{'S', "a"}, {'a', "aa"}}}, "a"), all_words({1})).derivation
Meeting first_outside(const ET0L& system, const RegularLanguage& language,
                      const Budget& budget = {});

/// A derivation of a word of L(G) in as few steps as any needs; nothing if L(G) is empty. What a
/// sequence of tables does is then the set of letters that can become words of terminals by it, so
/// there are at most 2^letters to look at.
///
/// Example: !first_word(et0l("S", {{{'S', "Sa"}}}, "a")).derivation
Meeting first_word(const ET0L& system, const Budget& budget = {});

}  // namespace algae
