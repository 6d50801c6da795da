#pragma once
// Rational operations within ET0L and EDT0L: further tables; deterministic tables stay deterministic.

#include "system/et0l.hpp"

namespace algae {

/// ET0L and EDT0L languages are closed under union, concatenation, star and plus (Rozenberg and Salomaa
/// 1980, IV.1 and V.1). The parts are derived one after the other with copies of the letters that are no
/// terminals, while all else stays as it is; a table that finishes a part makes terminals of its letters
/// and lets a letter fail that is none. All are O(size of the rules). Words of the second operand are
/// words by the names of their letters; the alphabet of the result begins with that of the first.

/// A new axiom becomes the first axiom in the tables of the first system, the second in those of the
/// second, and each table lets the letters of the other system fail. One table more than both have.
///
/// Example: is_deterministic(table_union(et0l("a", {{{'a', "aa"}}}), et0l("b", {{{'b', "bb"}}})))
ET0L table_union(const ET0L& left, const ET0L& right);

/// The finishing table starts the second part. One table more than both have.
///
/// Example: is_deterministic(table_concatenation(et0l("a", {{{'a', "aa"}}}), et0l("b", {{{'b', "bb"}}})))
ET0L table_concatenation(const ET0L& left, const ET0L& right);

/// The finishing table starts another part to the right, and the last one does not. Two tables more.
///
/// Example: is_deterministic(table_plus(et0l("a", {{{'a', "aa"}}})))
ET0L table_plus(const ET0L& system);

/// The same, or the empty word.
///
/// Example: is_deterministic(table_star(et0l("a", {{{'a', "aa"}}})))
ET0L table_star(const ET0L& system);

}  // namespace algae
