#pragma once

#include "base/budget.hpp"
#include "claim/judgement.hpp"
#include "language/language.hpp"

namespace algae {

// What languages have in common with others. Decided where both sides are finite or regular, where the left
// side of an inclusion is a language of a system without context (or made of such by operations under which these are closed)
// and the right side regular, where both are languages of D0L systems; otherwise a difference is looked for among
// short words and first generations, and a proof of a regular side within L(G) by induction on the length.
// Both throw what budget.check throws, BoundReached where a table is too large.

/// Whether every word of the first is in the second.
Judgement judge_inclusion(const Language& inner, const Language& outer, const Alphabet& alphabet,
                          const Budget& budget = {});

/// Whether they have the same words.
Judgement judge_equality(const Language& left, const Language& right, const Alphabet& alphabet,
                         const Budget& budget = {});

}  // namespace algae
