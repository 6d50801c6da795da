#pragma once

#include <vector>

#include "base/budget.hpp"
#include "system/et0l.hpp"

namespace algae {

/// A system without erasing rules for L(G) without the empty word; the tables keep their number, so E0L
/// languages are EP0L and ET0L languages EPT0L but for the empty word (Herman and Rozenberg 1975;
/// Rozenberg and Salomaa 1980, II.1 and V.1). Deterministic tables become nondeterministic.
///
/// The system is synchronised first. A letter of the result is a letter x together with a set of letters of
/// which nothing remains in the end; the system guesses of each letter whether something remains. Equal
/// letters of a word that vanish may vanish in the same way, so a set of them is enough, and it is kept
/// with some letter next to it that remains. Sets are the least ones that rules allow. Up to 2^letters
/// times more letters and, for a successor with n letters that may vanish, up to 2^n times more rules.
///
/// Throws what budget.check throws, and BoundReached if the system takes more than budget.memory.
///
/// Example: is_propagating(propagating(et0l("ab", {{{'a', "aa"}, {'a', ""}}})))
ET0L propagating(const ET0L& system, const Budget& budget = {});

/// The same for the words that remain of words of L(G), if any letters of them that `may_go` are left
/// out, without the empty word; `may_go` is by symbol.
///
/// Example: is_propagating(thinned(et0l("ab", {{{'a', "aa"}}}), {1, 0}))
ET0L thinned(const ET0L& system, const std::vector<char>& may_go, const Budget& budget = {});

/// Whether some word of L(G) has letters only that `may_go`: decided by the sets of letters that words
/// of each set of letters derive, up to 2^letters of them. Throws as `propagating`.
///
/// Example: !can_vanish(et0l("ab", {{{'a', "aa"}}}), {1, 0})
bool can_vanish(const ET0L& system, const std::vector<char>& may_go, const Budget& budget = {});

}  // namespace algae
