#pragma once

#include <vector>

#include "word/alphabet.hpp"

namespace algae {

/// The symbols of the second alphabet that have the names of those of the first, by symbol. Throws Error if
/// one is missing there.
std::vector<Symbol> renaming(const Alphabet& from, const Alphabet& to);

/// The word with each letter replaced.
///
/// Example: replaced({1, 0}, {5, 6}) == Word{6, 5}
Word replaced(Word word, const std::vector<Symbol>& letters);

}  // namespace algae
