#pragma once

#include "language/membership.hpp"

namespace algae {

/// Membership for an 0L system whose letters have one successor each. Where the language is infinite
/// the lengths of its words tend to infinity (growth functions of D0L systems: Rozenberg and Salomaa
/// 1980, I.3), so the numbers of letters of each generation, worked out up to |word|, are followed
/// until all letters that grow have outgrown the word; a generation is written out only if it has each
/// letter as often as the word has. Where the language is finite the generations themselves are
/// followed until they repeat.
Membership deterministic_membership(const OL& system, const Word& word, const Budget& budget = {});

/// The generations from 0 to `step`. Throws BoundReached if they have more than budget.letters letters
/// together.
Derivation deterministic_derivation(const OL& system, std::uint64_t step, const Budget& budget = {});

}  // namespace algae
