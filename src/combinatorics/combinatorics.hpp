#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "word/word.hpp"

// combinatorics: combinatorics on words, of one finite word: periods and borders, conjugates, Lyndon words, palindromes,
// factors, runs and squares; and of the infinite word of a morphism: how many factors of each length it has, for all lengths. Words are numbered from 0; the order of letters is that of their numbers, so whoever wants
// another order numbers them otherwise (`Alphabet::ranks`). n is the length of the word.
//
// Terms are those of Lothaire, "Algebraic Combinatorics on Words" (2002): a period p of w has w[i] = w[i + p] wherever both are;
// a border of w is a word that begins and ends w and is not w; a conjugate of uv is vu; a run is a factor with a period p, at least 2p
// letters long, that no letter on either side prolongs.

namespace algae {

/// The lengths of the borders of a word but for the empty one, in increasing order. O(n), by the failure function of Knuth,
/// Morris and Pratt.
///
/// Example: borders({0, 1, 0, 0, 1}) == std::vector<std::size_t>{2}
std::vector<std::size_t> borders(const Word& word);

/// The periods of a word in increasing order, n the last; none of the empty word. O(n).
///
/// Example: periods({0, 1, 0, 0, 1}) == std::vector<std::size_t>{3, 5}
std::vector<std::size_t> periods(const Word& word);

/// The primitive root: the shortest word of which this one is a power; the empty word of itself. O(n).
///
/// Example: primitive_root({0, 1, 0, 1}) == Word{0, 1}
Word primitive_root(const Word& word);

/// The conjugate that is least in lexicographic order. O(n) (Duval 1983).
///
/// Example: least_conjugate({1, 0, 0}) == Word{0, 0, 1}
Word least_conjugate(const Word& word);

/// Where the factors of the Lyndon factorisation begin: w = l1 l2 ... with Lyndon words l1 >= l2 >= ... (Chen, Fox and Lyndon). O(n), and
/// no memory but the answer (Duval 1983).
///
/// Example: lyndon_factorisation({0, 1, 0, 0, 1}) == std::vector<std::size_t>{0, 2}
std::vector<std::size_t> lyndon_factorisation(const Word& word);

/// A factor of a word: the letters from `begin` on.
struct Occurrence {
    std::size_t begin = 0, length = 0;
    bool operator==(const Occurrence&) const = default;
};

struct PalindromicFactors {
    std::size_t count =
        0;  // different ones, without the empty word; at most n (Droubay, Justin and Pirillo 2001)
    std::vector<Occurrence> longest;  // each once, where it occurs first
    /// A factorisation into as few palindromes as possible; their number is the palindromic length.
    std::vector<Occurrence> fewest;
    /// n - count: 0 says that the word is rich (Brlek, Hamel, Nivat and Reutenauer 2004).
    std::size_t defect = 0;
};

/// The palindromes in a word. O(n log n) for few letters: by the palindromic tree (Rubinchik and Shur 2018), with series of palindromes (Fici,
/// Gagie, Kärkkäinen and Kempa 2014). About 60 bytes for each letter. Throws BoundReached at the end of the time or memory, and
/// Error beyond 2^31 - 2 letters.
///
/// Example: palindromic_factors({0, 1, 0, 0, 1}).count == 5
PalindromicFactors palindromic_factors(const Word& word, const Budget& budget = {});

/// A run: the letters from `begin` to `end`, which is beyond the last one, and the least period.
struct Run {
    std::size_t begin = 0, end = 0, period = 0;
    bool operator==(const Run&) const = default;
};

struct WordRepetitions {
    std::vector<Run>
        runs;  // by where they begin, then by period; fewer than n (Bannai et al. 2017)
    std::uint64_t distinct_squares = 0;  // different words uu, u not empty
    /// The greatest exponent of a factor, its length by its least period; 1 in a word without runs may be too low, since
    /// runs are at least 2 long: then nothing.
    std::optional<Rational> greatest_exponent;
};

/// The runs of a word and its squares. O(n log n): Lyndon roots (Bannai, I, Inenaga, Nakashima, Takeda and Tsuruta 2017) on suffix arrays;
/// squares are counted in the runs, as rotations of their roots. About 50 bytes for each letter. Throws as `palindromic_factors`.
///
/// Example: repetitions_in({0, 1, 0, 0, 1}).runs.size() == 1
WordRepetitions repetitions_in(const Word& word, const Budget& budget = {});

/// How many different factors of 0, 1, ..., n letters a word has. O(n) after its suffix array, by the lengths of common prefixes of neighbours
/// (Kasai et al. 2001). Throws as `palindromic_factors`.
///
/// Example: factor_counts({0, 1, 0, 0, 1}) == std::vector<std::uint64_t>{1, 2, 3, 3, 2, 1}
std::vector<std::uint64_t> factor_counts(const Word& word, const Budget& budget = {});

/// An Abelian period: after a head of fewer than `period` letters come blocks of `period` letters with the same letters each as often, and a
/// tail; head and tail hold no letter more often than a block.
struct AbelianPeriod {
    std::size_t head = 0, period = 0;
    bool operator==(const AbelianPeriod&) const = default;
};

/// The Abelian periods of a word in increasing order, each with its least head (Constantinescu and Ilie 2006). O(n^2) for each
/// letter of the alphabet. Throws BoundReached at the end of the time.
///
/// Example: abelian_periods({0, 1, 0, 0, 1})[0] == AbelianPeriod{1, 2}
std::vector<AbelianPeriod> abelian_periods(const Word& word, const Budget& budget = {});

/// Bispecial factors of an infinite word whose lengths l(0), l(1), ... satisfy a linear recurrence.
struct BispecialChain {
    std::int64_t multiplicity = 0;  // of each: bilateral, not 0
    std::vector<Integer> lengths;   // the first ones, increasing
    /// l(k) = recurrence[0] l(k-1) + recurrence[1] l(k-2) + ... for all k >= recurrence.size(), which is at most lengths.size().
    std::vector<Integer> recurrence;

    /// The lengths up to `most`, in increasing order. O(the number of them, times that of the terms).
    std::vector<Integer> lengths_to(const Integer& most) const;
};

/// How many factors of n letters an infinite word has, for all n: p(0) = 1, p(1) is the number of its letters, and p(n+2) - 2 p(n+1) + p(n)
/// is the sum of the bilateral multiplicities of the bispecial factors of n letters (Cassaigne 1997). Those of multiplicity
/// 0, and chains that cancel each other from some length on, are left out beyond it.
struct ComplexityForAll {
    std::size_t letters = 0;
    /// By length, the sum of the multiplicities of the bispecial factors that no chain has; not 0.
    std::vector<std::pair<Integer, std::int64_t>> single;
    std::vector<BispecialChain> chains;
    /// How many derived words there are before they repeat, and how many of them repeat.
    std::size_t before = 0, period = 0;

    /// p(n) for n >= from; where there are no chains, and only then.
    struct Linear {
        Integer slope, constant, from;
    };
    std::optional<Linear> linear() const;
    /// p(n). O(the number of bispecial factors of fewer letters), which is O(log n).
    Integer value(const Integer& n) const;
};

/// Of the infinite word h(h(h(...(a)...))), where h(a) begins with a and a comes back in it; letters that h may forget are allowed. The word is
/// derived by the returns to its first letter, again and again, until a derived word comes back, which always happens if h
/// is primitive (Durand 1998); the bispecial factors of one derived word give those of the word before.
///
/// Throws Error if h(a) does not begin with a or a does not come back, and BoundReached if the derived words get too many or too
/// large, which happens to morphisms that are not primitive, or at the end of the time.
///
/// Example: complexity_for_all(Morphism({{0, {0, 1}}, {1, {0}}}), 0).value(1000) == 1001
ComplexityForAll complexity_for_all(const Morphism& h, Symbol a, const Budget& budget = {});

/// Repetitions of an infinite word that come of each other: words v that occur again p letters later, which no letter on either side
/// prolongs, so factors of |v| + p letters with the period p. Numbers of letters of v and of the p letters follow
/// v(k+1) = step^rounds v(k) + added and p(k+1) = step^rounds p(k); then |v| = lengths v(k) + behind and p = lengths p(k).
struct RepetitionChain {
    std::vector<Integer> word, period;  // v(0), p(0)
    std::size_t rounds = 1;
    std::vector<Integer> added;
    Integer behind = 0;
};

/// Repetitions of an infinite word: all v and p as in `RepetitionChain`, but for some with |v| < least p, and some that are neither longer nor of
/// smaller period than others here.
struct GreatestRepetitions {
    bool periodic = false;  // the word; then nothing else is here
    Rational least = 0;     // below the limit of |v|/p of some chain
    IntegerMatrix step;     // primitive, its rate above 1
    std::vector<Integer> lengths;
    std::vector<RepetitionChain> chains;
    std::vector<std::pair<Integer, Integer>> single;  // |v| and p
};

/// Of the infinite word of a morphism, as `complexity_for_all` and under the same conditions; throws as that does.
///
/// Example: greatest_repetitions(Morphism({{0, {0, 1}}, {1, {0}}}), 0).chains.empty() == false
GreatestRepetitions greatest_repetitions(const Morphism& h, Symbol a, const Budget& budget = {});

}  // namespace algae
