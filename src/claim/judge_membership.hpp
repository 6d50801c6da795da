#pragma once

#include "base/budget.hpp"
#include "claim/judgement.hpp"
#include "language/language.hpp"

namespace algae {

/// Whether the word is in the language, by the definition of each operation: of a star all ways to cut the
/// word, of an image all words with this image. Complete where the parts can be decided: undecided are
/// words that a system with context neither derives nor is seen to leave out within a bound, and images
/// under morphisms that erase letters of languages that are neither regular nor of L-systems without
/// context.
///
/// Throws what budget.check throws, BoundReached where a table is too large.
Judgement judge_membership(const Language& language, const Word& word, const Alphabet& alphabet,
                           const Budget& budget = {});

}  // namespace algae
