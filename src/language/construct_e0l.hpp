#pragma once
// Rational operations within E0L: one table stays one table.

#include "system/et0l.hpp"

namespace algae {

/// E0L languages are closed under union, concatenation, star and plus (Herman and Rozenberg 1975;
/// Rozenberg and Salomaa 1980, II.1). All of these synchronise the systems first and are O(size of the
/// rules). Words of the second operand are words by the names of their letters; the alphabet of the
/// result begins with that of the first. Throw Error if a system has several tables.

/// A new axiom becomes one axiom or the other.
///
/// Example: e0l_union(et0l("a", {{{'a', "aa"}}}), et0l("b", {{{'b', "bb"}}})).tables.size() == 1
ET0L e0l_union(const ET0L& left, const ET0L& right);

/// A new axiom becomes the two axioms after each other, and each waits as long as it likes before it
/// starts. Synchronised, both parts have terminals only from the same step on, or the word fails.
///
/// Example: e0l_concatenation(et0l("a", {{{'a', "aa"}}}), et0l("b", {{{'b', "bb"}}})).tables.size() == 1
ET0L e0l_concatenation(const ET0L& left, const ET0L& right);

/// Several axioms after each other, as many as it likes, each of which waits as above.
///
/// Example: e0l_plus(et0l("a", {{{'a', "aa"}}})).tables.size() == 1
ET0L e0l_plus(const ET0L& system);

/// The same, or the empty word.
///
/// Example: e0l_star(et0l("a", {{{'a', "aa"}}})).tables.size() == 1
ET0L e0l_star(const ET0L& system);

}  // namespace algae
