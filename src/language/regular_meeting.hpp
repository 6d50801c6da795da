#pragma once

#include <cstdint>
#include <optional>

#include "base/budget.hpp"
#include "language/membership.hpp"
#include "language/regular_language.hpp"

namespace algae {

/// Whether some word of L(G) is in a regular language, and how that is known.
struct Meeting {
    /// A derivation of such a word, of one in the first generation that has any, and there of a shortest.
    std::optional<Derivation> derivation;
    /// With a derivation: its number of steps. Without: what words derived from the letters in `step`
    /// steps do to the states of the automaton is what those of `earlier` steps do, so no later
    /// generation has a word that those before have not the like of.
    std::uint64_t step = 0;
    std::uint64_t earlier = 0;
};

/// Decided: for every t and every letter the pairs of states between which some word derived from the letter
/// in t steps leads; those of t give those of t + 1 by one product of relations a rule, and there are
/// finitely many. Time O(states^3 / 64 * size of the rules) a step; the steps before relations repeat are
/// few for most systems, but bounded only by the number of families of relations.
/// Throws what budget.check throws, and BoundReached if the derivation takes more than budget.memory or
/// its words have more than budget.letters letters together.
///
/// Example: first_meeting(ol("a", {{'a', "aa"}}), finite_set({{0, 0, 0}, {0, 0, 0, 0}})).step == 2
Meeting first_meeting(const OL& system, const RegularLanguage& language, const Budget& budget = {});

/// Whether L(G) is contained in a regular language: nothing is derived then, otherwise the derivation of
/// a word outside.
///
/// Example: !first_outside(ol("a", {{'a', "aa"}}), all_words({0})).derivation
Meeting first_outside(const OL& system, const RegularLanguage& language, const Budget& budget = {});

}  // namespace algae
