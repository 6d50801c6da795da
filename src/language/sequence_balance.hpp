#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "language/sequence_overflow.hpp"

namespace algae {

/// A proof that two D0L systems with the same axiom w have the same sequence. g and h are their rules.
///
/// The states and a state of refusal form an automaton: letter a leads from overflow v to
/// overflow_step(v, a) if that is a state, otherwise to refusal. Let T_k(a) be the map of states by the word
/// g^k(a); T_0 is the automaton's, and T_{k+1}(a) the product of T_k over the letters of g(a). T_steps =
/// T_earlier, so no map comes after them that did not come before; and for every k < steps the word g^k(w)
/// leads from the empty overflow to itself. So g and h have the same value on every word g^k(w), and by
/// induction g^k(w) = h^k(w) for all k.
struct Balance {
    std::size_t bound = 0;         // no overflow is longer
    std::vector<Overflow> states;  // the empty one first
    std::uint64_t steps = 0;
    std::uint64_t earlier = 0;
};

/// What came of the attempt to close these states.
struct BalanceAttempt {
    std::optional<Balance> balance;  // if the proof holds
    std::uint64_t generation =
        0;  // otherwise: the first whose word does not lead back through these states
};

/// Tries the proof with these states, of which the first is the empty overflow, and the accessible
/// letters of the left system. Time O(states * size of the rules) a step; the maps repeat since there are
/// finitely many of them (found as Brent 1980 does, so with less than 3 times the least number of steps).
/// Throws what budget.check throws, and BoundReached if the maps take more than budget.memory.
///
/// Example: try_balance(over_common_alphabet(d0l("a", {{'a', "ab"}}), d0l("a", {{'a', "ab"}})), {Overflow{}}).balance->steps == 1
BalanceAttempt try_balance(const SequencePair& systems, std::vector<Overflow> states,
                           const Budget& budget = {});

}  // namespace algae
