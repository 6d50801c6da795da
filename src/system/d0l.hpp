#pragma once

#include <memory>
#include <vector>

#include "system/lsystem.hpp"
#include "system/view.hpp"
#include "word/hom.hpp"

namespace algae {

/// A D0L system: a word and a morphism (Rozenberg and Salomaa 1980, I.1). Every letter has exactly
/// one successor, a letter without a rule itself. Analyses look only at `letters`, those that
/// occur in some h^n(axiom): the others could cost without bound and mean nothing.
struct D0L {
    std::shared_ptr<const Alphabet> alphabet;
    Word axiom;
    /// Total on the alphabet. Its brackets are set if they match in every word of the system
    /// because no rule rewrites them and every successor matches its own; then a Branching fold
    /// gives them their meaning, otherwise they are letters like any other.
    Morphism rules;
    std::vector<Symbol> letters;  // accessible from the axiom, in order of first access
    std::string name;             // for messages

    const Word& successor(Symbol a) const { return rules.images[a]; }
};

/// The system as a D0L system, if it is one: no contexts, conditions, parameters, probabilities
/// below 1, tables or terminals, and at most one rule a letter (the same rule twice is one rule).
/// Interpretation rules and turtle settings do not matter. O(size of the system).
View<D0L> as_d0l(const LSystem& system);

/// A D0L system from its parts: total rules over the alphabet.
D0L make_d0l(std::shared_ptr<const Alphabet> alphabet, Word axiom, std::vector<Word> images,
             std::string name = {});

/// The same with one character a letter, for tests and examples.
///
/// Example: d0l("b", {{'a', "ab"}, {'b', "a"}}).letters.size() == 2
D0L d0l(const std::string& axiom, const std::vector<std::pair<char, std::string>>& productions);

/// Whether no accessible letter has the empty successor (a PD0L system).
bool is_propagating(const D0L& system);

}  // namespace algae
