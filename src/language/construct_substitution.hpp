#pragma once

#include <map>

#include "system/et0l.hpp"

namespace algae {

/// Every letter of a word of L(G) replaced by some word of the language of its system: ET0L languages are
/// closed under substitution of ET0L languages (Rozenberg and Salomaa 1980, V.1), with that under
/// regular substitution. Words of all systems are words by the names of their letters.
///
/// A word of copies that are no terminals is derived first. A further table makes waiting letters of its
/// terminals, lets any of those start with their axiom, and makes terminals of what is derived from
/// others; what is not done fails. So letters start one after the other, and each uses tables as it likes.
/// One table more than all systems have together. O(size of all rules).
///
/// Throws Error if a letter that may occur in L(G) has no system.
///
/// Example: substituted(et0l("a", {{{'a', "aa"}}}), {{0, et0l("b", {{{'b', "bb"}}})}}).tables.size() == 3
ET0L substituted(const ET0L& system, const std::map<Symbol, ET0L>& languages);

}  // namespace algae
