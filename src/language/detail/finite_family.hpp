#pragma once

// Finite languages and the families of L-systems: the search for a system, and the proof in sentences where
// there is none.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "system/system.hpp"
#include "verify/verify.hpp"

namespace algae {

/// The successors of each letter, by symbol; none for symbols that do not occur.
using RuleTable = std::vector<std::vector<Word>>;

/// An 0L system (one table) or T0L system that generates a finite language.
struct FiniteWitness {
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    std::vector<RuleTable> tables;
};

/// Whether the system generates exactly this language and is of this family, by derivation step by
/// step; it stops at the first word outside the language. A system of a family without tables has
/// one table.
bool generates(const FiniteWitness& witness, const FiniteLanguage& language, Family family,
               const Budget& budget = {});

/// The system as a file would write it. Tables are named 1, 2, ... where there are several.
LSystem to_lsystem(const FiniteWitness& witness, const std::string& name = {});

/// The system on one line: "axiom aa; a -> ε | a", each table's rules between brackets.
std::string to_string(const FiniteWitness& witness);

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
    bool out_of_time = false;                      // undecided because the time was over
};

/// Decides whether some system of the family generates exactly this finite language. Undecided only where a
/// bound (cases, time, memory) was reached. Exponential in the worst case.
///
/// Throws Interrupted if the work was asked to stop.
///
/// Example: decide_family(finite_language({"a", "aa"}), Family{}).truth == Truth::refuted
/// Example: decide_family(finite_language({"", "a", "aa"}), Family{}).truth == Truth::proved
FamilyAnswer decide_family(const FiniteLanguage& language, Family family,
                           const FamilyOptions& options = {}, const Budget& budget = {});

/// The proof by cases: one sentence a line, cases indented by two blanks, with marks as in detail/proof.hpp. It says
/// what `flaw_in` checks and nothing else.
std::vector<std::string> marked_proof(const FamilyObstruction& obstruction);

}  // namespace algae
