#pragma once

#include "base/budget.hpp"
#include "claim/judgement.hpp"
#include "exact/integer.hpp"
#include "language/language.hpp"

namespace algae {

// How many words a language has. All throw what budget.check throws, BoundReached where a table is too large.

/// Whether the language is finite: worked out where it can be, otherwise by a part of it that is not.
Judgement judge_finite(const Language& language, const Alphabet& alphabet,
                       const Budget& budget = {});

/// Whether it has no word.
Judgement judge_empty(const Language& language, const Alphabet& alphabet,
                      const Budget& budget = {});

/// Whether it has exactly so many words.
Judgement judge_size(const Language& language, const Integer& size, const Alphabet& alphabet,
                     const Budget& budget = {});

}  // namespace algae
