#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "system/ol.hpp"

namespace algae {

/// One use of a rule: successor number `choice` of a letter.
struct RuleUse {
    Symbol letter = 0;
    std::size_t choice = 0;
    bool operator==(const RuleUse&) const = default;
};

/// Why a language is infinite: starting with letters.front(), each rule has the letter of the next
/// one, the last has the first letter again; and the first rule has `other` besides, which can go
/// on for ever. So n rounds give a word with n letters and more.
struct EndlessRound {
    std::vector<RuleUse> rules;
    Symbol other = 0;
};

/// Whether L(G) is finite: a proof if it is not.
struct Finiteness {
    bool finite = false;
    std::optional<EndlessRound> round;  // where it is infinite
};

/// Decided, in the time of the components of letters.
///
/// Theorem. Call a letter lasting if some derivation from it never becomes empty. L(G) is infinite
/// if and only if some accessible letter a has a rule a -> u b v where b derives a word with a in
/// it and u v has a lasting letter.
/// Proof. With such a rule, n rounds from a to a give a and n lasting letters, each of which is
/// kept from then on. Without it, a lasting letter on a cycle is followed by one lasting letter as
/// long as it stays among the letters of its cycles, and cycles can only be left for others that do not
/// lead back, so the number of lasting letters of a word is bounded; letters that do not last are
/// gone after as many steps as there are letters, so their number is bounded too.
/// (For D0L systems: a bounded growth function, Rozenberg and Salomaa 1980, I.3.)
///
/// Example: !finiteness(ol("a", {{'a', "ab"}})).finite
Finiteness finiteness(const OL& system);

/// The number of words of a finite L(G): for D0L systems by `repetition`, otherwise as the words that
/// the minimal automaton of the language accepts, so there may be far more words than could be listed.
/// Throws Error if the language is infinite, BoundReached if an automaton needs more than
/// budget.memory.
///
/// Example: number_of_words(ol("aa", {{'a', ""}, {'a', "a"}})) == 3
Integer number_of_words(const OL& system, const Budget& budget = {});

/// From generation `preperiod` on every generation is the same word as the one `period` later; both
/// are least.
struct Repetition {
    std::uint64_t preperiod = 0;
    Integer period = 1;
    bool operator==(const Repetition&) const = default;
};

/// When the words of a D0L system with a finite language repeat. Once every lasting letter lies on a
/// cycle of letters, a word is back when all of them are, so the period is the least common multiple of
/// the lengths of their cycles; generations are compared across it by squaring h^period.
/// Throws Error if a letter has several successors or the language is infinite.
///
/// Example: repetition(ol("ca", {{'a', "b"}, {'b', "a"}, {'c', "d"}})) == Repetition{1, 2}
Repetition repetition(const OL& system, const Budget& budget = {});

}  // namespace algae
