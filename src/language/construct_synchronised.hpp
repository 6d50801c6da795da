#pragma once

#include "system/et0l.hpp"

namespace algae {

/// An equivalent synchronised system (Rozenberg and Salomaa 1980, II.1 and V.1): every successor of a
/// terminal is a letter that fails, so the letters of a derived word become terminals in one and the
/// same step. Its axiom is one letter, which occurs in no successor, and a successor has terminals only
/// or none. The tables keep their number and names; deterministic ones become nondeterministic.
///
/// Each letter has a copy that is no terminal; copies are rewritten as the letters were, and where a
/// successor has terminals only a copy may also become that word itself. O(size of the rules).
///
/// Example: synchronised(et0l("a", {{{'a', "aa"}}})).axiom.size() == 1
ET0L synchronised(const ET0L& system);

}  // namespace algae
