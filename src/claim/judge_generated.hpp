#pragma once

#include <string>
#include <vector>

#include "base/budget.hpp"
#include "claim/judgement.hpp"
#include "language/language.hpp"
#include "language/membership.hpp"

namespace algae {

/// Whether a system derives the word as a word of its language. Tables are followed exactly. A system with
/// context is derived until its words repeat or, where no rule erases, are longer than the word; the answer is
/// undecided where neither happens within a bound.
Judgement judge_generated(const SourceSystem& system, const Word& word, const Alphabet& alphabet,
                          const Budget& budget = {});

/// The words of a derivation with arrows between them, shortened if it is long.
///
/// Example: arrows({{{}, {}}, {{}}}, Alphabet()) == "ε => ε"
std::string arrows(const Derivation& derivation, const Alphabet& alphabet);

/// The words and tables of a derivation as a certificate writes them.
nlohmann::ordered_json derivation_json(const Derivation& derivation, const Alphabet& alphabet);

}  // namespace algae
