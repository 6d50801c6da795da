#pragma once

#include "base/budget.hpp"
#include "language/gsm.hpp"
#include "language/regular_language.hpp"
#include "system/et0l.hpp"

namespace algae {

/// What a generalised sequential machine writes when it reads words of L(G), and L(G) intersected with a
/// regular language: what the machine writes that copies its words. E0L, ET0L and, for deterministic
/// machines, EDT0L languages are closed under both (Herman and Rozenberg 1975; Rozenberg and Salomaa
/// 1980, II.1 and IV.1). Words of the machine and of the regular language are over the symbols of the system.
///
/// A letter of the result is a letter x between two states p and q: what is derived from it leads the
/// machine from p to q. The states between the letters of a successor are guessed, and a terminal
/// becomes what the machine writes on a move from p to q. Only triples are made where some word derived
/// from x leads from p to q. O(size of the rules * states^(letters of a successor + 1)) at most.
/// All throw what budget.check throws, and BoundReached if the system takes more than budget.memory.

/// The tables keep their number. The system is synchronised first; where the machine writes nothing for
/// a letter, as `e0l_image`.
ET0L e0l_gsm_image(const ET0L& system, const Gsm& machine, const Budget& budget = {});

/// Example: e0l_intersection(et0l("a", {{{'a', "aa"}}}), finite_set({{0, 0}})).tables.size() == 1
ET0L e0l_intersection(const ET0L& system, const RegularLanguage& language,
                      const Budget& budget = {});

/// Deterministic tables stay deterministic if the machine is. Then all letters x of a word derive the same,
/// so a table guesses for all letters at once what they will do to the states, and the triples check it.
/// What letters do to states after the last tables, counted backwards, are finitely many families of
/// functions; each has a copy of each table: up to states^(states * letters) copies, mostly few.
ET0L table_gsm_image(const ET0L& system, const Gsm& machine, const Budget& budget = {});

/// Example: is_deterministic(table_intersection(et0l("a", {{{'a', "aa"}}}), finite_set({{0, 0}})))
ET0L table_intersection(const ET0L& system, const RegularLanguage& language,
                        const Budget& budget = {});

}  // namespace algae
