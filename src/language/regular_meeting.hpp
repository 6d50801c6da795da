#pragma once

#include <cstdint>
#include <optional>

#include "base/budget.hpp"
#include "language/membership.hpp"
#include "language/regular_language.hpp"
#include "system/et0l.hpp"

namespace algae {

/// Whether some word of L(G) is in a regular language, and how that is known.
struct Meeting {
    /// A derivation of such a word, of one in the first generation that has any; with one table of
    /// a shortest there, with several of a shortest by the same tables.
    std::optional<Derivation> derivation;
    /// With a derivation: its number of steps. Without: with one table what words derived from the
    /// letters in `step` steps do to the states of the automaton is what those of `earlier` steps
    /// do, so no later generation has a word that those before have not the like of; with several
    /// tables what they do by any `step` of them is what they do by fewer.
    std::uint64_t step = 0;
    std::uint64_t earlier = 0;
    /// How many families of relations between states were looked at.
    std::uint64_t states = 0;
};

/// Decided: for every sequence of tables and every letter the pairs of states between which some
/// word leads that the letter derives by these tables; those of a sequence without its first table
/// give those of the sequence by one product of relations a rule, and there are finitely many. Time
/// O(states^3 / 64 * size of the rules) for each; with one table they are few for most systems, but
/// bounded only by the number of families of relations, and with several tables there can be
/// exponentially many, which are kept. Throws what budget.check throws, and BoundReached if these
/// or the derivation take more than budget.memory or its words have more than budget.letters
/// letters together.
///
/// Example: first_meeting(ol("a", {{'a', "aa"}}), finite_set({{0, 0, 0}, {0, 0, 0, 0}})).step == 2
Meeting first_meeting(const OL& system, const RegularLanguage& language, const Budget& budget = {});

/// Example: first_meeting(et0l("a", {{{'a', "aa"}}, {{'a', "b"}}}), finite_set({{1, 1}})).step == 2
Meeting first_meeting(const ET0L& system, const RegularLanguage& language,
                      const Budget& budget = {});

/// Whether L(G) is contained in a regular language: nothing is derived then, otherwise the
/// derivation of a word outside.
///
/// Example: !first_outside(ol("a", {{'a', "aa"}}), all_words({0})).derivation
Meeting first_outside(const OL& system, const RegularLanguage& language, const Budget& budget = {});

/// Example: !first_outside(et0l("S", {{{'S', "a"}, {'a', "aa"}}}, "a"), all_words({1})).derivation
Meeting first_outside(const ET0L& system, const RegularLanguage& language,
                      const Budget& budget = {});

/// A derivation of a word of L(G) in as few steps as any needs; nothing if L(G) is empty. What a
/// sequence of tables does is then the set of letters that can become words of terminals by it, so
/// there are at most 2^letters to look at.
///
/// Example: !first_word(et0l("S", {{{'S', "Sa"}}}, "a")).derivation
Meeting first_word(const ET0L& system, const Budget& budget = {});

}  // namespace algae
