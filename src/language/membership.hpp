#pragma once
// language: languages as values and what can be decided about them: membership, finiteness, regular
// languages, families.

#include <cstdint>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "system/ol.hpp"

namespace algae {

/// A derivation: every letter of a word is replaced by one of its successors, which makes the next
/// word. words.front() is the axiom; letter i of words[t] becomes its successor number choices[t][i].
struct Derivation {
    std::vector<Word> words;
    std::vector<std::vector<std::uint32_t>> choices;  // one fewer than words
    std::vector<std::uint32_t> tables = {};           // of each step; empty where the system has one table
};

/// Whether the derivation begins with the axiom and each step does what the rules say. Linear time.
bool is_derivation(const OL& system, const Derivation& derivation);

/// Whether a word is in the language of a system, and how that is known.
struct Membership {
    enum class Reason {
        derived,     // yes: it is a word of generation `step`, and of none before
        foreign,     // no: letter number `position` of the word is in no word of the language
        repeated,    // no: what the letters derive within the word in `step` steps is what they derive in
                     // `earlier` steps, so nothing new is derived afterwards, and no generation before had the word
        outgrown,    // no: from generation `step` on all words are longer, and no generation before had it
        periodic,    // no: generation `step` is the same word as generation `earlier` (D0L systems)
        nonterminal, // no: letter number `position` of the word is no terminal (language/tables_membership.hpp)
        exhausted,   // no: what the letters derive within the word by any `step` tables is what they derive by
                     // fewer, so nothing new is derived afterwards, and none of the `states` families seen has it
    };
    bool member = false;
    Reason reason = Reason::derived;
    std::uint64_t step = 0;
    std::uint64_t earlier = 0;
    std::uint64_t position = 0;
    std::uint64_t states = 0;
    std::vector<std::uint32_t> tables = {};  // of a member, where there are several: those of its steps
};

/// Whether the word is in L(G), decided: complete, with erasing rules too.
///
/// For each t the table of all (letter, factor of the word) with letter =>^t factor gives that of
/// t + 1 (one product of factors a rule), and says whether the axiom derives the word in t steps. There
/// are finitely many tables, so they repeat. Time O(|word|^3 / 64 * size of the rules) a step; the
/// steps before tables repeat are O(|word|) times a number that depends on the rules, which can be
/// as large as the least common multiple of the lengths of cycles of letters. For a system with one
/// rule a letter the numbers of letters of each generation are followed instead: O(size of the
/// rules) a step, until every letter that grows has outgrown the word.
///
/// Throws what budget.check throws, and BoundReached if two tables take more than budget.memory.
///
/// Example: membership(ol("a", {{'a', "a"}, {'a', "aa"}}), {0, 0, 0}).step == 2
Membership membership(const OL& system, const Word& word, const Budget& budget = {});

/// A derivation of the word in exactly `step` steps, if there is one, with tables kept only here and there on the
/// way and worked out again in between: O(sqrt(step)) tables. What is erased is erased as soon as the
/// rules can. Throws BoundReached if its words have more than budget.letters letters together.
///
/// Example: !find_derivation(ol("a", {{'a', "aa"}}), {0, 0, 0}, 2)
std::optional<Derivation> find_derivation(const OL& system, const Word& word, std::uint64_t step,
                                          const Budget& budget = {});

/// The same of a word that has one. Throws Error if there is none.
///
/// Example: derivation(ol("a", {{'a', "a"}, {'a', "aa"}}), {0, 0, 0}, 2).words.size() == 3
Derivation derivation(const OL& system, const Word& word, std::uint64_t step, const Budget& budget = {});

}  // namespace algae
