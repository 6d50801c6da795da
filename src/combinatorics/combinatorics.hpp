#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "word/word.hpp"

// combinatorics: combinatorics on words, of one finite word: periods and borders, conjugates, Lyndon words, palindromes,
// factors, runs and squares; of a morphism: what its images say; and of the infinite word of a morphism: how many factors of each length it has,
// for all lengths, and which families it belongs to. Words are numbered from 0; the order of letters is that of their numbers, so whoever wants
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

/// Where the factors of the factorisation of Lempel and Ziv begin: each is the longest word that begins at an earlier place, too, where
/// it may overlap itself, or else a new letter (Crochemore 1986). O(n) after the suffix array. Throws as `palindromic_factors`.
///
/// Example: lempel_ziv_factorisation({0, 1, 0, 1, 0, 0}) == std::vector<std::size_t>{0, 1, 2, 5}
std::vector<std::size_t> lempel_ziv_factorisation(const Word& word, const Budget& budget = {});

/// What a word over at most two letters is among the finite Sturmian words (Lothaire 2002, chapter 2).
struct SturmianProperties {
    /// Two factors of one length differ by at most one in the number of a letter: it is a factor of a Sturmian word.
    bool balanced = false;
    /// Coprime periods p and q with n = p + q - 2; then it is a palindrome.
    bool central = false;
    bool standard = false;     // a letter, or a central word with both letters behind it
    bool christoffel = false;  // balanced and a Lyndon word, in the order of letters
};

/// Nothing if the word has more than two letters. O(n).
///
/// Example: sturmian_properties({0, 0, 1, 0, 1})->christoffel
std::optional<SturmianProperties> sturmian_properties(const Word& word);

/// What the images say of a morphism from the words over its domain into themselves, d letters.
struct MorphismProperties {
    std::size_t shortest = 0, longest = 0;          // image
    bool prefix_code = false, suffix_code = false;  // no image begins, or ends, another one
    /// Two different words with the same image, with as few letters in all as can be; none if the images are a code, so that the morphism is injective.
    std::optional<std::pair<Word, Word>> same_image;
    /// The images begin, or end, with different letters.
    bool left_marked = false, right_marked = false;
    /// How many conjugates it has, which move a common first letter of all images behind them, or back; with itself.
    std::size_t conjugates = 1;
    bool cyclic = false;  // all images are powers of one word
    /// The images are p q, or all are q p, with one palindrome p and palindromes q (Hof, Knill and Simon 1995); it, or a conjugate.
    bool class_p = false, conjugate_of_class_p = false;
    bool automorphism = false;  // of the free group
    bool sturmian = false;      // an automorphism with two letters (Wen and Wen 1994)
    /// A shortest word without squares whose image has one. `square_free` says nothing if there are too many words to try.
    std::optional<Word> makes_square;
    std::optional<bool> square_free;
    std::optional<bool> overlap_free;  // of two letters, without empty images
    Polynomial characteristic;         // of the matrix of numbers of letters
    Integer determinant;
    bool irreducible = false;  // the polynomial
    /// The greatest eigenvalue is above 1, and its conjugates are inside the unit circle (a Pisot number); or one is inside and the others on it (a Salem number).
    bool pisot = false, salem = false;
};

/// Throws Error if an image has a letter outside the domain, and BoundReached at the end of the time.
///
/// Codes are decided by dangling suffixes (Sardinas and Patterson 1953), automorphisms by folding (Stallings 1983), morphisms without squares by the
/// images of short words (Crochemore 1982), those without overlaps by that of abbabaab (Berstel and Seebold 1993). O(s^2) for images of s letters
/// in all, but for square-free words, of which at most 100,000 are tried.
///
/// Example: morphism_properties(Morphism({{0, {0, 1}}, {1, {0}}})).sturmian
MorphismProperties morphism_properties(const Morphism& h, const Budget& budget = {});

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
    /// The extension graph of each factor, which joins the letters before it with those behind it where both stand around it, is a tree (Berthe et al. 2015).
    bool dendric = false;
    /// Every bispecial factor has a letter that stands on one side of it at least, always the same one: a word is episturmian, with all reversals of factors
    /// and at most one left special factor of each length (Droubay, Justin and Pirillo 2001).
    bool episturmian = false;
    /// That, and it has all letters on the other side, so that there are (d-1) n + 1 factors for d letters (Arnoux and Rauzy 1991); Sturmian if d is 2.
    bool arnoux_rauzy = false;

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

/// An infinite word of a morphism, cut into the returns to its first letter, which are its letters in the derived word: these are of the word that
/// comes next in the list.
struct DerivedWord {
    Morphism h;  // letters 0, 1, ... in the order of first occurrence in the word
    std::vector<Word> returns;
};
/// After the last one come those from `before` on again: so the derived words of all beginnings of the first one, which is the word itself, are here.
struct DerivedWords {
    std::vector<DerivedWord> words;
    std::size_t before = 0;
    std::vector<Symbol> letters;  // what the letters of the first one stand for
};

/// Throws as `complexity_for_all`.
///
/// Example: derived_words(Morphism({{0, {0, 1}}, {1, {0}}}), 0).words.size() == 1
DerivedWords derived_words(const Morphism& h, Symbol a, const Budget& budget = {});

/// What is known of the infinite word of a primitive morphism whose images all have q letters, if it is not periodic (Dekking 1978).
struct ConstantLength {
    std::size_t length = 0;  // q
    /// The greatest number without a divisor in common with q that divides all distances of the first letter from where it comes back.
    std::size_t height = 1;
    /// The least number of blocks of `height` letters that stand at one place of the images of all of them, under a power of the morphism. It is 1
    /// exactly if the spectrum of the word is pure point.
    std::size_t column_number = 0;
    /// Every letter comes back in some distance for ever (Jacobs and Keane 1969).
    bool toeplitz = false;
};

/// Of the word that h(h(h(...(a)...))) tends to. Nothing if not all images have q >= 2 letters, h is not primitive or the word is periodic. Throws as
/// `complexity_for_all`, and BoundReached if there are more than 100,000 sets of blocks.
///
/// Example: constant_length(Morphism({{0, {0, 1}}, {1, {0, 0}}}), 0)->toeplitz
std::optional<ConstantLength> constant_length(const Morphism& h, Symbol a,
                                              const Budget& budget = {});

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
