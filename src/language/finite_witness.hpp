#pragma once

#include <string>
#include <vector>

#include "base/budget.hpp"
#include "system/lsystem.hpp"
#include "verify/family.hpp"
#include "verify/finite_language.hpp"

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

}  // namespace algae
