#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "base/budget.hpp"

namespace algae {

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

/// What a sequence of tables does is known from its first table and what the rest does: the states
/// of all sequences are found from that of no step, shortest sequences first, until one is to be
/// stopped at or nothing new comes. With one table three states are kept (Brent 1980), with several
/// all.
///
/// `Process` has a type State, State first(), State next(state, table), bool stops(state),
/// std::uint64_t bytes(state) and std::size_t hash(state). Throws what budget.check throws, and
/// BoundReached if the states take more than budget.memory.
template <class Process>
TablesWalk walk_of_tables(Process& process, std::size_t tables, const Budget& budget);

namespace tables_walk {

template <class Process>
TablesWalk by_one_table(Process& process, const Budget& budget) {
    typename Process::State state = process.first(), remembered = state;
    budget.check_memory(3 * process.bytes(state), "what the letters derive");
    std::uint64_t remembered_step = 0;
    for (std::uint64_t step = 0, until = 1;; ++step) {
        budget.check();
        if (step > 0 && state == remembered) return {std::nullopt, step, remembered_step, step};
        if (process.stops(state)) {
            budget.check_memory(step * sizeof(std::uint32_t), "the tables of a derivation");
            return {std::vector<std::uint32_t>(static_cast<std::size_t>(step), 0), step, 0, step + 1};
        }
        if (step == until) {
            remembered = state;
            remembered_step = step;
            until *= 2;
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

template <class Process>
TablesWalk walk_of_tables(Process& process, std::size_t tables, const Budget& budget) {
    return tables == 1 ? tables_walk::by_one_table(process, budget)
                       : tables_walk::by_several_tables(process, tables, budget);
}

}  // namespace algae
