#pragma once

// Languages of powers, {a^n b^(2n+1) : n >= 0}: their words, what they are as regular languages and systems, and
// sequences of words whose exponents are functions of n.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "language/language.hpp"
#include "system/system.hpp"

namespace algae {

/// The language as claims write it.
std::string to_string(const Powers& powers, const Alphabet& alphabet);

/// The word for these values of the numbers. Throws BoundReached if it has more than budget.letters letters.
Word word_of(const Powers& powers, const std::vector<std::uint64_t>& values,
             const Budget& budget = {});

/// The values of the numbers for which the word is this one; nothing if there are none. O(length of the word) values are
/// tried, each by its length first.
std::optional<std::vector<std::uint64_t>> values_of(const Powers& powers, const Word& word,
                                                    const Budget& budget = {});

/// Whether every exponent is a sum of multiples of the numbers and a constant.
bool is_linear(const Powers& powers);

/// The same language as a regular expression, where each exponent is linear and no number stands in two of them;
/// otherwise null.
Language regular_form(const Powers& powers);

/// An EDT0L system for the language: one table for each number, which makes it larger by one, and one that ends. A letter
/// stands for n^k b^n copies of a word and becomes those for (n+1)^k b^(n+1). Throws BoundReached if it is too large.
ET0L system_of(const Powers& powers, const Alphabet& alphabet, const Budget& budget = {});

/// A function of n: the coefficients of n^k b^n, by b and k.
using Count = std::map<std::pair<Integer, std::uint64_t>, Integer>;

/// Words w_0, w_1, ...: each the same words, repeated as often as functions of n say.
using WordSequence = std::vector<std::pair<Word, Count>>;

/// The words of the language in the order of its only number; or those of a context-free grammar with the rules
/// S -> x S y and S -> z. Nothing for other languages.
std::optional<WordSequence> sequence_of(const Language& language);

/// `a^n b^n`.
std::string to_string(const WordSequence& sequence, const Alphabet& alphabet);

/// Whether the words are seen to be the same for every n: both have one normal form, in which words are primitive,
/// constants stand as far left as they can, and equal neighbours are one. False says nothing.
bool is_same(const WordSequence& left, const WordSequence& right);

/// Whether word number n of the D0L system is seen to be word number n of the sequence for all n, by induction on n.
bool follows(const D0L& system, const WordSequence& sequence);

/// Why the words of a language of powers are not of a Chomsky family.
struct BeyondFamily {
    enum class Why {
        lengths,  // they grow faster than linearly, which lengths of an infinite context-free language do not
        blocks,  // `letters` stand in one block each, whose exponents grow with the same number: two for REG, three for CF
        marker,  // the letter stands in every word once, with powers on both sides
    };
    Why why = Why::lengths;
    std::vector<Symbol> letters;
};

/// That the language of powers of one number is not REG or CF, where one of the reasons is found.
std::optional<BeyondFamily> beyond_family(const Powers& powers, const std::string& family);

/// Whether the language is seen to be context-free: linear, each number in at most two exponents, and of any two numbers
/// the one between the two exponents of the other or beside them.
bool is_nested(const Powers& powers);

}  // namespace algae
