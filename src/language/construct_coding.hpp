#pragma once

#include <map>

#include "base/budget.hpp"
#include "system/et0l.hpp"
#include "system/ol.hpp"

namespace algae {

/// An 0L system and a coding, a homomorphism to single letters.
struct CodedOL {
    OL system;
    std::map<Symbol, Word> coding;
};

/// An 0L system whose language has L(G) as its image under a coding: every E0L language with a non-empty
/// word is a coding of an 0L language (Ehrenfeucht and Rozenberg 1974; Rozenberg and Salomaa 1980,
/// II.2). The images of codings are E0L by `e0l_image`.
///
/// Rules that erase are eliminated and the system is synchronised. The sets B(t) of letters that derive
/// terminal words in exactly t steps are those of t - 1 seen through the rules, so from some s on they come
/// again after p steps. A terminal word of step n >= s is derived through a word of letters of B(r) in step
/// n - r, where r of s, ..., s + p - 1 differs from n by a multiple of p; every letter of B(r) has words of B(r)
/// in p steps, and terminal words in r. So L(G) is a finite set and, for each r, what a finite
/// substitution without empty words makes of the words of an 0L system with the p-step rules. The new
/// letters are those of the blocks that it gives: the first letter of a block is rewritten to the blocks
/// of a successor, the others vanish. The axiom is a shortest word of L(G), whose first letter starts
/// everything else. Words and blocks are listed: exponential in s + p and beyond.
///
/// Throws Error if the system has several tables or derives no non-empty word of terminals, what
/// budget.check throws, and BoundReached if words take more than budget.memory.
///
/// Example: coding_of_0l(et0l("S", {{{'S', "a"}, {'S', "aa"}, {'a', "S"}}}, "a")).system.axiom.size() == 1
CodedOL coding_of_0l(const ET0L& system, const Budget& budget = {});

}  // namespace algae
