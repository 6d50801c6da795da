#pragma once

#include <optional>
#include <set>

#include "base/budget.hpp"
#include "system/d0l.hpp"
#include "system/ol.hpp"

namespace algae {

/// The same system as an 0L system, one successor a letter.
///
/// Example: ol_of(d0l("a", {{'a', "aa"}})).successors[0].size() == 1
OL ol_of(const D0L& system);

/// All words of a D0L system with a finite language. Throws BoundReached if they take more than
/// budget.memory.
///
/// Example: words_of(d0l("ab", {{'a', "b"}, {'b', "a"}})).size() == 2
std::set<Word> words_of(const D0L& system, const Budget& budget = {});

/// The first generation whose word is not in the set; none if the language of the system is finite
/// and all its words are. Ends, since a D0L system with an infinite language has no word twice.
std::optional<std::uint64_t> first_generation_outside(const D0L& system,
                                                      const std::set<Word>& words,
                                                      const Budget& budget = {});

}  // namespace algae
