#pragma once

#include "system/et0l.hpp"

namespace algae {

/// The system that derives the words written backwards: axiom and successors are. Same letters, tables
/// and terminals, and every property of the rules, so all families of L-systems without context are
/// closed under reversal: 0L, D0L, P0L, T0L, E0L, ET0L, EDT0L, ... O(size of the rules).
///
/// Example: spell(*reversed(et0l("ab", {{{'a', "ab"}}})).alphabet, reversed(et0l("ab", {{{'a', "ab"}}})).axiom) == "ba"
ET0L reversed(const ET0L& system);

}  // namespace algae
