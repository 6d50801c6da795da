#pragma once

#include <map>
#include <optional>

#include "base/budget.hpp"
#include "verify/certificate.hpp"

namespace algae::verify {

/// Whether a word is in a language, by the definition of each operation: of an L(G) without context by the
/// tables of which letters derive which factors of the word, until nothing new comes; with context by
/// deriving. Throws BoundReached where that takes more than the budget.
bool contains(const Language& language, const Word& word, const Alphabet& alphabet,
              const Budget& budget);

/// The image of a word under a morphism; nothing if a letter has none.
std::optional<Word> image_of(const Word& word, const std::map<Symbol, Word>& morphism,
                             const Budget& budget);

/// Whether the system derives a word, from here, in this number of steps, or in any. Terminals do not matter.
bool derives(const System& system, const Word& from, const Word& to,
             const std::optional<Integer>& steps, const Budget& budget);

}  // namespace algae::verify
