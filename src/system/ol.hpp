#pragma once

#include <memory>
#include <string>
#include <vector>

#include "system/lsystem.hpp"
#include "system/view.hpp"
#include "word/hom.hpp"

namespace algae {

/// An 0L system: a word and a finite substitution (Rozenberg and Salomaa 1980, II.1). Every letter
/// has at least one successor, a letter without a rule itself. Successors of a letter are distinct.
struct OL {
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    std::vector<std::vector<Word>> successors;  // by symbol
    std::vector<Symbol> letters;                // accessible from the axiom, in order of first access
    std::string name;
};

/// The system as an 0L system, if it is one: no contexts, conditions, parameters, probabilities,
/// tables or terminals. O(size of the system).
View<OL> as_ol(const LSystem& system);

/// An 0L system with one character a letter, for tests and examples.
OL ol(const std::string& axiom, const std::vector<std::pair<char, std::string>>& productions);

/// Whether no accessible letter has the empty word among its successors (a P0L system).
bool is_propagating(const OL& system);

/// Why the rules of a system are not those of an 0L system: the first construct that goes beyond
/// them, by name and place; empty if there is none. `probabilities` says whether probabilities
/// below 1 count as such.
std::string beyond_ol(const LSystem& system, bool probabilities = true);

}  // namespace algae
