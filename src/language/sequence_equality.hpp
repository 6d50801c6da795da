#pragma once

#include <cstdint>
#include <optional>

#include "base/budget.hpp"
#include "exact/integer.hpp"
#include "language/sequence_balance.hpp"

namespace algae {

/// The first generation in which two sequences of words differ, and where.
struct SequenceDifference {
    std::uint64_t generation = 0;
    Integer
        position;  // of the first letter, counted from 0, that is not the same or that only one word has
    Integer from;      // where the letters shown begin: a little before the position
    Word left, right;  // the letters of both words from there on, over the alphabet of both systems
    Integer left_length, right_length;
};

/// Whether two D0L systems have the same word in every generation, and how that is known.
struct SequenceEquality {
    bool equal = false;
    std::optional<Balance> balance;                // if they have
    std::optional<SequenceDifference> difference;  // if they have not
};

/// D0L sequence equivalence, decided.
///
/// Let g and h be the rules. As long as the words w_0, ..., w_k of both are the same, w_{k+1} is the same
/// if and only if g(w_k) = h(w_k). What the letters of w_k do to the overflow of one image over the other is
/// followed exactly, letters with the same past taken together, so that no word is written out: this
/// finds the first difference, and every overflow that words w_0, ..., w_k have. When a generation has none
/// that was not there before, `try_balance` looks whether these suffice for ever.
///
/// Theorem (Culik and Fris 1977; Ehrenfeucht and Rozenberg 1978): if the sequences are the same, the overflows
/// are finitely many, so one of the two searches ends.
/// Proof. Begin with p = q = the identity of A*, B = A, m = 0; there always is a product f = pq of m factors g and h
/// with q: A* -> B*, p: B* -> A*, so w_n = p(q(w_{n-m})) for n >= m. Take e = gp or hp and reduce the words
/// e(b): leave empty ones out, keep equal ones once, and where one is a proper prefix of another, take it away
/// there; until none is. Then e = p'q' where p' is a prefix code. If there are fewer words than letters
/// in B, go on with p', q'q, f' = p'q'q (it is gf or hf) and m + 1: this happens less often than there are
/// letters. Otherwise q' is a product of maps b -> cb, and gp and hp have bounded delay. Now
/// let x be a word with gp(x) = hp(x), and follow the overflow along x. While it is longer than a bound
/// that depends on the delay, the next letter of x is determined by it, and so on until it is shorter
/// again; it gets longer from finitely many short overflows by one letter each. So finitely many overflows
/// occur at all. Those along w_n = p(x) are at most a fixed number of letters from these.
/// (So systems need not be simplified through smaller alphabets B first: it changes no answer.)
///
/// Throws BoundReached, and says what was tried, if the overflows take more than budget.memory or time is up.
///
/// Example: equal_sequences(d0l("ab", {{'a', "abb"}, {'b', "aabba"}}),
///     d0l("ab", {{'a', "abbaabb"}, {'b', "a"}})).difference->generation == 3
SequenceEquality equal_sequences(const D0L& left, const D0L& right, const Budget& budget = {});

}  // namespace algae
