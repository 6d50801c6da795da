#pragma once

#include <tuple>
#include <vector>

#include "verify/family.hpp"
#include "verify/finite_language.hpp"

namespace algae {

/// One production letter -> image.
struct LetterRule {
    Symbol letter = 0;
    Word image;

    bool operator==(const LetterRule&) const = default;
    bool operator<(const LetterRule& other) const {
        return std::tie(letter, image) < std::tie(other.letter, other.image);
    }
};

/// Why a rule is in no table that keeps the language closed, given which rules are still possible
/// and which are known to be there. Either no choice of one possible rule for each letter of `word`,
/// this one among them, sends `word` into the language (`images` is empty), or `images`, letter by
/// letter, is a derivation step that uses this rule and rules that are there only, and leaves it.
struct ExcludedRule {
    LetterRule rule;
    Word word;
    std::vector<Word> images;
};

/// A proof by cases that no rules left over can generate the language (or, for a table, keep it closed).
struct ObstructionCase {
    enum class End {
        no_image,  // `letter` has no possible rule left
        needed,    // the rule excluded last is known to be there
        sources,   // two disjoint sets of words, neither reached from outside it, or {ε} alone
        conflict,  // a step from `word` leaves the language: one of `rules`, the rules it uses that
        // are not known to be there, is missing. In case i it is rules[i], and the rules before it are there
        choice  // one of `rules`, the possible rules of `letter`, is its only one
    };
    std::vector<ExcludedRule> excluded;  // one after the other
    End end = End::no_image;
    Symbol letter = 0;
    std::vector<std::vector<Word>> sources;
    Word word;  // of a conflict: `word` and what each of its letters becomes
    std::vector<Word> images;
    std::vector<LetterRule> rules;
    std::vector<ObstructionCase> cases;  // one for each of `rules`
};

/// Rules that are together in no table that keeps the language closed.
struct ImpossibleTable {
    std::vector<LetterRule> rules;
    ObstructionCase why;
};

/// Why a finite language is not of a family: data that can be checked without any search. At first
/// all factors of words of the language are possible images of every letter (in a propagating
/// family, all but ε): what the letter becomes is a factor of a word of the language.
///
/// Without tables `root` speaks of the rules of the system. With tables it speaks of all tables at
/// once, and every step into its `sources` from outside uses all rules of one of `impossible`.
struct FamilyObstruction {
    Family family;
    bool empty_axiom = false;  // whether the empty word is allowed as an axiom
    FiniteLanguage language;
    ObstructionCase root;
    std::vector<ImpossibleTable> impossible;
};

}  // namespace algae
