#pragma once

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "language/regular_language.hpp"
#include "system/et0l.hpp"

namespace algae {

/// A finite L(G) as the automaton of its words, of which there may be far more than could be
/// listed.
///
/// What an accessible letter derives by a sequence of tables, while all letters finish, stands
/// between other words in words of L(G), so if L(G) is finite these are finitely many finite
/// languages: the families of all sequences are found from those without their first table, until
/// nothing new comes. Throws Error if the language is infinite, BoundReached if automata or
/// families take more than budget.memory.
///
/// Example: finite_words(et0l("S", {{{'S', "a"}}, {{'S', "b"}}}, "ab")) == finite_set({{1}, {2}})
RegularLanguage finite_words(const ET0L& system, const Budget& budget = {});

/// The number of words of a finite L(G). Throws as `finite_words` does.
///
/// Example: number_of_words(et0l("aa", {{{'a', "b"}, {'a', "c"}}, {{'a', ""}}})) == 6
Integer number_of_words(const ET0L& system, const Budget& budget = {});

}  // namespace algae
