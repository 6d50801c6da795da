#pragma once

#include <string>

#include "base/verdict.hpp"
#include "language/finite_family.hpp"

namespace algae {

/// The proof in plain sentences, by cases, one statement a line, cases indented by two blanks. It
/// says what `flaw_in` checks and nothing else.
std::string proof_text(const FamilyObstruction& obstruction);

/// The answer as a verdict: the system, the proof, or what was tried.
///
/// Example: verdict_on(finite_language({"a"}), Family{}, FamilyAnswer{}).truth == Truth::undecided
Verdict verdict_on(const FiniteLanguage& language, Family family, const FamilyAnswer& answer);

}  // namespace algae
