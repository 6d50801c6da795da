#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/budget.hpp"
#include "base/verdict.hpp"
#include "language/finite_witness.hpp"
#include "verify/family.hpp"
#include "verify/finite_language.hpp"
#include "verify/finite_obstruction.hpp"

namespace algae {

struct FamilyOptions {
    bool empty_axiom = false;         // whether the empty word may be the axiom
    std::uint64_t cases = 1'000'000;  // how many cases may be looked at
};

/// Whether a finite language is of a family, with the system that generates it or the reason why
/// none does. Both can be checked again: `generates`, `flaw_in`.
struct FamilyAnswer {
    Truth truth = Truth::undecided;
    std::optional<FiniteWitness> witness;          // proved
    std::optional<FamilyObstruction> obstruction;  // refuted
    std::string tried;                             // undecided
};

/// Decides whether some system of the family generates exactly this finite language. Complete: an
/// image of a letter is a factor of a word of the language, so there are finitely many systems, and
/// leaving out a rule keeps the language closed and makes fewer words reachable, so rules are only
/// taken out, case by case; with tables, a step is possible in some closed table or in none.
/// Undecided only where a bound (cases, time, memory) was reached. Exponential in the worst case.
///
/// Throws Interrupted if the work was asked to stop.
///
/// Example: decide_family(finite_language({"a", "aa"}), Family{}).truth == Truth::refuted
/// Example: decide_family(finite_language({"", "a", "aa"}), Family{}).truth == Truth::proved
FamilyAnswer decide_family(const FiniteLanguage& language, Family family,
                           const FamilyOptions& options = {}, const Budget& budget = {});

}  // namespace algae
