#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "language/equivalence_sections.hpp"
#include "language/sequence_balance.hpp"

namespace algae {

/// A section of the one sequence that is the same sequence of words as one of the other: the rules of the
/// section are the powers h^step and h^stride of the rules of the systems.
struct SectionMatch {
    Section section;
    Balance balance;  // of (w_left, g^step) and (v_right, h^stride)
};

/// A word that only one of two languages has.
struct LanguageDifference {
    bool in_left = false;          // the language that has it
    std::uint64_t generation = 0;  // of which it is the word
    Integer length;
    std::optional<Word> word;  // over the alphabet of both, unless it is too long to be written out
    std::optional<std::uint64_t>
        alike;  // the only generation of the other with as many of each letter, if there is one
};

/// Whether two D0L systems generate the same language, and how that is known.
struct LanguageEquality {
    bool equal = false;
    bool finite = false;             // both languages: then they were compared word by word
    std::uint64_t words_in_all = 0;  // of equal finite languages
    std::vector<std::pair<std::uint64_t, std::uint64_t>>
        words;                           // equal infinite ones: the same words, by generation
    std::vector<SectionMatch> sections;  // and all others
    std::optional<LanguageDifference> difference;  // if they are not equal
};

/// D0L language equivalence, decided by sequence equivalence (after Nielsen 1974).
///
/// Finite languages are compared word by word. Let both be infinite, with sequences w and v.
/// Theorem. If the words of both languages have the same sets of letter counts, then there is a finite plan of
/// single words and sections (w_{s+pn}), (v_{t+qn}), n = 0, 1, ..., in which each word of each sequence stands once,
/// and letter counts on both sides agree. The languages are equal if and only if all that is paired is equal.
/// Proof. No two words of a sequence have the same counts (see GenerationCounts). So there is one bijection
/// n -> m(n) for which w_n and v_m(n) have the same counts, and equal words must be paired by it: this is the
/// last sentence. Lengths grow like n^d c^n, up to constant factors, c >= 1 (one system's sections all grow
/// alike, since one step multiplies the length by a bounded factor). If c > 1, both sequences have the same c and
/// d and |m(n) - n| is bounded, otherwise m would not be onto or not be injective; for each difference
/// the n with m(n) = n + difference are the zeros of linear recurrences, so an ultimately periodic set (Skolem, Mahler,
/// Lech). If c = 1, counts are vectors of polynomials on the classes of numbers modulo some period; where
/// two of them of equal degree meet again and again with bounded gaps, m(n) is linear with a rational slope there;
/// other meetings have gaps that tend to infinity, and since the meetings with bounded gaps leave nothing out
/// or a whole class, which the others could not fill, there are finitely many others.
///
/// More and more generations are counted until the plan shows, or a word appears whose counts the other
/// language does not have: as soon as all later words of the other are longer.
/// Throws BoundReached, and says what was tried, if this takes more than budget.memory or time is up.
///
/// Example: equal_languages(d0l("a", {{'a', "b"}, {'b', "aa"}}), d0l("a", {{'a', "b"}, {'b', "aa"}})).equal
LanguageEquality equal_languages(const D0L& left, const D0L& right, const Budget& budget = {});

}  // namespace algae
