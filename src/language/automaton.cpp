#include "language/detail/regular.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

// Finite automata: nondeterministic ones to build with, deterministic ones to decide with.
//
// A regular language is handled through one deterministic automaton that depends on the language alone, so
// equality of languages is equality of automata. The way there: operations build a nondeterministic automaton
// with silent moves; sets of states make it deterministic (Rabin and Scott 1959), up to 2^states of them, which
// is where the budget is checked; Hopcroft's algorithm (1971) finds Nerode's equivalence in O(letters * states
// * log(states)); last come the steps that make the form unique: letters that are in no accepted word are
// dropped, and states are numbered in shortlex order of the first words that lead to them.
//
// Hopcroft's partition is kept as one array of states in which each block is a range. A block is split by
// moving its marked states to the front of its range. A new block waits as a splitter only if it is the smaller
// half, unless the old block waits anyway.

namespace algae {

bool Dfa::accepts(const Word& word) const {
    std::size_t state = initial;
    for (const Symbol a : word) {
        if (a >= letters) return false;
        state = step(state, a);
    }
    return accepting[state] != 0;
}

std::size_t Nfa::add_state(bool accepting) {
    states.push_back({{}, {}, accepting});
    return states.size() - 1;
}

void Nfa::add_path(std::size_t from, const Word& word, std::size_t to) {
    if (word.empty()) {
        states[from].silent.push_back(to);
        return;
    }
    for (std::size_t i = 0; i + 1 < word.size(); ++i) {
        const std::size_t between = add_state();
        states[from].moves.emplace_back(word[i], between);
        from = between;
    }
    states[from].moves.emplace_back(word.back(), to);
}

std::size_t Nfa::add_states(const Nfa& other) {
    const std::size_t shift = states.size();
    for (State state : other.states) {
        for (auto& [letter, to] : state.moves) to += shift;
        for (std::size_t& to : state.silent) to += shift;
        states.push_back(std::move(state));
    }
    return shift;
}

std::vector<std::size_t> distances(const Dfa& automaton) {
    std::vector<std::vector<std::size_t>> before(automaton.states());
    for (std::size_t s = 0; s < automaton.states(); ++s)
        for (Symbol a = 0; a < automaton.letters; ++a) before[automaton.step(s, a)].push_back(s);
    std::vector<std::size_t> distance(automaton.states(), automaton.states()), queue;
    for (std::size_t s = 0; s < automaton.states(); ++s)
        if (automaton.accepting[s]) {
            distance[s] = 0;
            queue.push_back(s);
        }
    for (std::size_t i = 0; i < queue.size(); ++i)
        for (const std::size_t s : before[queue[i]])
            if (distance[s] == automaton.states() && !automaton.accepting[s]) {
                distance[s] = distance[queue[i]] + 1;
                queue.push_back(s);
            }
    return distance;
}

Nfa as_nfa(const Dfa& automaton) {
    const std::vector<std::size_t> distance = distances(automaton);
    const auto is_useful = [&](std::size_t s) { return distance[s] < automaton.states(); };
    Nfa found;
    for (std::size_t s = 0; s < automaton.states(); ++s) {
        found.add_state(automaton.accepting[s] != 0);
        for (Symbol a = 0; a < automaton.letters; ++a)
            if (is_useful(automaton.step(s, a)))
                found.states[s].moves.emplace_back(a, automaton.step(s, a));
    }
    if (is_useful(automaton.initial)) found.initial.push_back(automaton.initial);
    return found;
}

Nfa reversed(const Nfa& automaton) {
    Nfa found;
    found.states.resize(automaton.states.size());
    for (std::size_t s = 0; s < automaton.states.size(); ++s) {
        for (const auto& [letter, to] : automaton.states[s].moves)
            found.states[to].moves.emplace_back(letter, s);
        for (const std::size_t to : automaton.states[s].silent)
            found.states[to].silent.push_back(s);
        if (automaton.states[s].accepting) found.initial.push_back(s);
    }
    for (const std::size_t s : automaton.initial) found.states[s].accepting = true;
    return found;
}

Dfa widened(const Dfa& automaton, std::size_t letters) {
    if (letters <= automaton.letters) return automaton;
    Dfa found{letters, automaton.initial, automaton.accepting, {}};
    const std::size_t dead = automaton.states();
    found.accepting.push_back(0);
    found.transitions.assign(found.states() * letters, dead);
    for (std::size_t s = 0; s < automaton.states(); ++s)
        for (Symbol a = 0; a < automaton.letters; ++a)
            found.transitions[s * letters + a] = automaton.step(s, a);
    return found;
}

namespace {

/// Sorted numbers of states.
using States = std::vector<std::size_t>;

struct Hash {
    std::size_t operator()(const States& states) const {
        std::uint64_t hash = states.size();
        for (const std::size_t s : states) hash = (hash ^ s) * 0x9E3779B97F4A7C15u + (hash >> 29);
        return static_cast<std::size_t>(hash);
    }
};

/// The states and all that silent moves lead to.
States closed(const Nfa& automaton, States states, std::vector<char>& seen) {
    States found;
    const auto see = [&](std::size_t s) {
        if (seen[s]) return;
        seen[s] = 1;
        found.push_back(s);
    };
    for (const std::size_t s : states) see(s);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const std::size_t s : automaton.states[found[i]].silent) see(s);
    for (const std::size_t s : found) seen[s] = 0;
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

Dfa determinised(const Nfa& automaton, const Budget& budget) {
    std::size_t letters = 0;
    for (const Nfa::State& state : automaton.states)
        for (const auto& [letter, to] : state.moves)
            letters = std::max<std::size_t>(letters, letter + 1);
    std::vector<char> seen(automaton.states.size(), 0);
    std::unordered_map<States, std::size_t, Hash> number;
    std::vector<const States*> sets;
    Dfa found{letters, 0, {}, {}};
    std::uint64_t bytes = 0;
    const auto number_of = [&](States states) {
        const auto [place, is_new] = number.try_emplace(std::move(states), sets.size());
        if (is_new) {
            sets.push_back(&place->first);
            const bool accepts =
                std::any_of(place->first.begin(), place->first.end(),
                            [&](std::size_t s) { return automaton.states[s].accepting; });
            found.accepting.push_back(accepts);
            bytes += (place->first.size() + letters + 8) * sizeof(std::size_t);
        }
        return place->second;
    };
    number_of(closed(automaton, automaton.initial, seen));
    for (std::size_t s = 0; s < sets.size(); ++s) {
        budget.check();
        budget.check_memory(bytes, "a deterministic automaton");
        std::map<Symbol, States> reached;
        for (const std::size_t from : *sets[s])
            for (const auto& [letter, to] : automaton.states[from].moves)
                reached[letter].push_back(to);
        found.transitions.resize((s + 1) * letters);
        for (Symbol a = 0; a < letters; ++a)
            found.transitions[s * letters + a] =
                number_of(closed(automaton, std::move(reached[a]), seen));
    }
    return found;
}

namespace {

/// The reachable part, its states numbered in shortlex order of the first words that lead to them.
Dfa in_order(const Dfa& automaton) {
    std::vector<std::size_t> number(automaton.states(), automaton.states()),
        order{automaton.initial};
    number[automaton.initial] = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
        for (Symbol a = 0; a < automaton.letters; ++a) {
            const std::size_t to = automaton.step(order[i], a);
            if (number[to] == automaton.states()) {
                number[to] = order.size();
                order.push_back(to);
            }
        }
    Dfa found{automaton.letters, 0, {}, {}};
    for (const std::size_t s : order) {
        found.accepting.push_back(automaton.accepting[s]);
        for (Symbol a = 0; a < automaton.letters; ++a)
            found.transitions.push_back(number[automaton.step(s, a)]);
    }
    return found;
}

/// A partition of the states into blocks that can be split.
struct Blocks {
    struct Range {
        std::size_t begin = 0, end = 0, marked = 0;  // the first `marked` ones
        std::size_t size() const { return end - begin; }
    };
    std::vector<std::size_t> order, place, block;
    std::vector<Range> ranges;

    explicit Blocks(std::size_t states)
        : order(states), place(states), block(states, 0), ranges{{0, states, 0}} {
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::iota(place.begin(), place.end(), std::size_t{0});
    }
    /// Returns whether it is the first of its block.
    bool mark(std::size_t state) {
        Range& range = ranges[block[state]];
        const std::size_t border = range.begin + range.marked;
        if (place[state] < border) return false;
        std::swap(order[border], order[place[state]]);
        std::swap(place[order[place[state]]], place[state]);
        return range.marked++ == 0;
    }
    /// Splits the marked states from the others; the new block, or none if all are marked.
    std::size_t split(std::size_t old) {
        const Range all = ranges[old];
        ranges[old].marked = 0;
        if (all.marked == all.size()) return none;
        const std::size_t border = all.begin + all.marked;
        ranges[old].begin = border;
        ranges.push_back({all.begin, border, 0});
        for (std::size_t i = all.begin; i < border; ++i) block[order[i]] = ranges.size() - 1;
        return ranges.size() - 1;
    }
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

/// For every state and letter the states that come to it with the letter.
struct Predecessors {
    std::vector<std::size_t> begin, states;

    explicit Predecessors(const Dfa& automaton)
        : begin(automaton.transitions.size() + 1, 0), states(automaton.transitions.size()) {
        const std::size_t letters = automaton.letters;
        for (std::size_t i = 0; i < automaton.transitions.size(); ++i)
            ++begin[automaton.transitions[i] * letters + i % letters + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        std::vector<std::size_t> next(begin.begin(), begin.end());
        for (std::size_t i = 0; i < automaton.transitions.size(); ++i)
            states[next[automaton.transitions[i] * letters + i % letters]++] = i / letters;
    }
};

/// Nerode's equivalence.
Blocks equivalent_states(const Dfa& automaton) {
    Blocks blocks(automaton.states());
    for (std::size_t s = 0; s < automaton.states(); ++s)
        if (automaton.accepting[s]) blocks.mark(s);
    std::vector<std::size_t> waiting{0};
    std::vector<char> waits{1};
    if (blocks.ranges[0].marked > 0 && blocks.split(0) != Blocks::none) {
        waiting.push_back(1);
        waits.push_back(1);
    }
    const Predecessors predecessors(automaton);
    while (!waiting.empty()) {
        const auto range = blocks.ranges[waiting.back()];
        waits[waiting.back()] = 0;
        waiting.pop_back();
        const std::vector<std::size_t> splitter(
            blocks.order.begin() + static_cast<std::ptrdiff_t>(range.begin),
            blocks.order.begin() + static_cast<std::ptrdiff_t>(range.end));
        for (Symbol a = 0; a < automaton.letters; ++a) {
            std::vector<std::size_t> touched;
            for (const std::size_t to : splitter) {
                const std::size_t at = to * automaton.letters + a;
                for (std::size_t i = predecessors.begin[at]; i < predecessors.begin[at + 1]; ++i)
                    if (blocks.mark(predecessors.states[i]))
                        touched.push_back(blocks.block[predecessors.states[i]]);
            }
            for (const std::size_t old : touched) {
                const std::size_t made = blocks.split(old);
                if (made == Blocks::none) continue;
                waits.push_back(0);
                // The smaller half is enough, unless the old block waits anyway.
                const std::size_t smaller =
                    blocks.ranges[made].size() <= blocks.ranges[old].size() ? made : old;
                const std::size_t added = waits[old] ? made : smaller;
                waits[added] = 1;
                waiting.push_back(added);
            }
        }
    }
    return blocks;
}

/// Without the last letters that are in no accepted word. The automaton is minimal.
Dfa narrowed(const Dfa& automaton) {
    // The state from which nothing is accepted, if there is one, is the only one without a way out.
    std::size_t dead = automaton.states();
    for (std::size_t s = 0; s < automaton.states(); ++s) {
        bool stays = !automaton.accepting[s];
        for (Symbol a = 0; a < automaton.letters && stays; ++a) stays = automaton.step(s, a) == s;
        if (stays) dead = s;
    }
    std::size_t letters = 0;
    for (std::size_t s = 0; s < automaton.states(); ++s)
        for (Symbol a = 0; a < automaton.letters; ++a)
            if (automaton.step(s, a) != dead) letters = std::max<std::size_t>(letters, a + 1);
    Dfa found{letters, automaton.initial, automaton.accepting, {}};
    for (std::size_t s = 0; s < automaton.states(); ++s)
        for (Symbol a = 0; a < letters; ++a) found.transitions.push_back(automaton.step(s, a));
    return found;
}

}  // namespace

Dfa minimal(const Dfa& automaton) {
    const Dfa reached = in_order(automaton);
    const Blocks blocks = equivalent_states(reached);
    Dfa quotient{reached.letters, blocks.block[reached.initial],
                 std::vector<char>(blocks.ranges.size(), 0),
                 std::vector<std::size_t>(blocks.ranges.size() * reached.letters)};
    for (std::size_t s = 0; s < reached.states(); ++s) {
        quotient.accepting[blocks.block[s]] = reached.accepting[s];
        for (Symbol a = 0; a < reached.letters; ++a)
            quotient.transitions[blocks.block[s] * reached.letters + a] =
                blocks.block[reached.step(s, a)];
    }
    return in_order(narrowed(quotient));
}

}  // namespace algae
