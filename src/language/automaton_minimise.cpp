#include <algorithm>
#include <numeric>

#include "language/automaton.hpp"

namespace algae {

namespace {

/// The reachable part, its states numbered in shortlex order of the first words that lead to them.
Dfa in_order(const Dfa& automaton) {
    std::vector<std::size_t> number(automaton.states(), automaton.states()), order{automaton.initial};
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
        for (Symbol a = 0; a < automaton.letters; ++a) found.transitions.push_back(number[automaton.step(s, a)]);
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

    explicit Blocks(std::size_t states) : order(states), place(states), block(states, 0), ranges{{0, states, 0}} {
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

    explicit Predecessors(const Dfa& automaton) : begin(automaton.transitions.size() + 1, 0), states(automaton.transitions.size()) {
        const std::size_t letters = automaton.letters;
        for (std::size_t i = 0; i < automaton.transitions.size(); ++i) ++begin[automaton.transitions[i] * letters + i % letters + 1];
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
        const std::vector<std::size_t> splitter(blocks.order.begin() + static_cast<std::ptrdiff_t>(range.begin),
                                                blocks.order.begin() + static_cast<std::ptrdiff_t>(range.end));
        for (Symbol a = 0; a < automaton.letters; ++a) {
            std::vector<std::size_t> touched;
            for (const std::size_t to : splitter) {
                const std::size_t at = to * automaton.letters + a;
                for (std::size_t i = predecessors.begin[at]; i < predecessors.begin[at + 1]; ++i)
                    if (blocks.mark(predecessors.states[i])) touched.push_back(blocks.block[predecessors.states[i]]);
            }
            for (const std::size_t old : touched) {
                const std::size_t made = blocks.split(old);
                if (made == Blocks::none) continue;
                waits.push_back(0);
                // The smaller half is enough, unless the old block waits anyway.
                const std::size_t smaller = blocks.ranges[made].size() <= blocks.ranges[old].size() ? made : old;
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
    Dfa quotient{reached.letters, blocks.block[reached.initial], std::vector<char>(blocks.ranges.size(), 0),
                 std::vector<std::size_t>(blocks.ranges.size() * reached.letters)};
    for (std::size_t s = 0; s < reached.states(); ++s) {
        quotient.accepting[blocks.block[s]] = reached.accepting[s];
        for (Symbol a = 0; a < reached.letters; ++a)
            quotient.transitions[blocks.block[s] * reached.letters + a] = blocks.block[reached.step(s, a)];
    }
    return in_order(narrowed(quotient));
}

}  // namespace algae
