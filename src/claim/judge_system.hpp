#pragma once

#include <cstdint>
#include <optional>

#include "base/budget.hpp"
#include "claim/claim.hpp"
#include "claim/judgement.hpp"
#include "system/d0l.hpp"

namespace algae {

// What statements say of systems themselves. All throw what budget.check throws and BoundReached; Error where
// the system is of no class that the statement can be about.

/// Whether the system derives the word: from a word or its axiom, in so many steps or any number of them. For a
/// system without context decided by the table of factors, for one with context by deriving.
Judgement judge_derivation(const SourceSystem& system, const Word& word,
                           const std::optional<Word>& from, std::optional<std::uint64_t> steps,
                           const Alphabet& alphabet, const Budget& budget = {});

/// Whether two D0L systems have the same word in every generation.
Judgement judge_sequences(const SourceSystem& left, const SourceSystem& right,
                          const Alphabet& alphabet, const Budget& budget = {});

/// Whether two D0L systems have words of the same length in every generation.
Judgement judge_growth(const SourceSystem& left, const SourceSystem& right,
                       const Budget& budget = {});

/// Whether the length of generation n of a D0L system is this expression in n.
Judgement judge_growth_formula(const SourceSystem& system, const Expression& formula,
                               const Budget& budget = {});

/// Whether the growth of a D0L system is of this class: zero, bounded, polynomial (of this degree), exponential.
Judgement judge_growth_class(const SourceSystem& system, const std::string& kind,
                             const std::optional<Integer>& degree, const Budget& budget = {});

/// The system as a D0L system. Throws Error that names it if it is none.
D0L as_d0l(const SourceSystem& system);

}  // namespace algae
