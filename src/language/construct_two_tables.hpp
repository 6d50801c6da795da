#pragma once

#include "system/et0l.hpp"

namespace algae {

/// An equivalent system with two tables (Rozenberg and Salomaa 1980, V.1), the system itself if it has no
/// more. Deterministic tables give deterministic ones, propagating ones propagating ones.
///
/// There is a copy of each letter for each table. The first table of the result turns copies: those for
/// table i become those for the next one, after the last those for the first. The second table rewrites
/// a copy for table i by the rules of table i and gives copies for the first, which alone are terminals.
/// All letters of a word are copies for the same table. O(tables * size of the rules).
///
/// Example: with_two_tables(et0l("a", {{{'a', "aa"}}, {{'a', "aaa"}}, {{'a', "b"}}})).tables.size() == 2
ET0L with_two_tables(const ET0L& system);

}  // namespace algae
