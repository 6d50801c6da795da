#pragma once

#include "language/membership.hpp"
#include "system/et0l.hpp"

namespace algae {

/// Whether the derivation begins with the axiom and each step does what its table says. (Its last
/// word is in L(G) if its letters are terminals.) Linear time.
bool is_derivation(const ET0L& system, const Derivation& derivation);

/// Whether the word is in L(G), decided: complete, with erasing rules too.
///
/// With one table the word is in L(G) if the 0L system of the table derives it and its letters are
/// terminals. With several, what the letters derive within the word is found for every sequence of
/// tables, from that of the sequence without its first table, shortest sequences first, until
/// nothing new comes (`first_meeting` with the one word). The problem is NP-complete for some fixed
/// systems (van Leeuwen 1975), so there may be exponentially many: all are kept, and where they
/// take more than budget.memory BoundReached is thrown, that is, the question stays undecided.
///
/// Example: membership(et0l("a", {{{'a', "aa"}}, {{'a', "aaa"}}}), Word(6, 0)).step == 2
Membership membership(const ET0L& system, const Word& word, const Budget& budget = {});

/// The derivation of a member as `membership` found it. Throws Error if it is not one, BoundReached
/// if the words have more than budget.letters letters together.
///
/// Example: derivation(et0l("S", {{{'S', "a"}}}, "a"), {1}, membership(et0l("S", {{{'S', "a"}}}, "a"), {1})).words.size() == 2
Derivation derivation(const ET0L& system, const Word& word, const Membership& found,
                      const Budget& budget = {});

/// The 0L system of the only table, in which every letter is a terminal. Throws Error if there are
/// several tables.
///
/// Example: without_terminals(et0l("S", {{{'S', "a"}}}, "a")).letters.size() == 2
OL without_terminals(const ET0L& system);

}  // namespace algae
