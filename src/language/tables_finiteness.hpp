#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "system/et0l.hpp"

namespace algae {

/// One step of one letter: by a table it becomes successor number `choice`, and the letter at
/// `place` of that is the one that is followed.
struct TableUse {
    std::uint32_t table = 0;
    Symbol letter = 0;
    std::uint32_t choice = 0;
    std::uint32_t place = 0;
    bool operator==(const TableUse&) const = default;
};
using Course = std::vector<TableUse>;

/// Why L(G) is infinite. By the tables of `round` the letter `again` becomes a word with itself
/// and, at another place, `other`, which becomes a word with itself by the same tables; so n rounds
/// give a word with n letters `other` and more. By the tables of `after` each of these becomes a
/// word of terminals that is not empty, and the other letters finish too.
struct EndlessTables {
    Symbol again = 0, other = 0;
    Course before;  // from a letter of the axiom to `again`
    Course round;   // from `again` to itself
    Course beside;  // from `again` to `other`: as `round` up to a step where only the place differs
    Course kept;    // from `other` to itself
    Course after;   // from `other` to a terminal
};

/// Whether the proof holds, by nothing but going along its courses and working out backwards which
/// letters finish. Linear time.
bool is_proof(const ET0L& system, const EndlessTables& proof);

/// Whether L(G) is finite: a proof if it is not.
struct TablesFiniteness {
    bool finite = false;
    std::optional<EndlessTables> endless;  // where it is infinite
};

/// Decided for every ET0L system. The finishing set of a sequence v of tables are the letters that
/// derive a word of terminals by v; let all letters of all words below be in the finishing sets of
/// the tables still to come, as they are in derivations of words of L(G).
///
/// Theorem. L(G) is infinite if and only if there are sequences x, u, v of tables such that v and
/// uv have the same finishing set F, and letters a, b such that the axiom derives by x a word with
/// a; a derives by u a word with a and b at two places; b derives by u a word with b, and by v a
/// word of terminals that is not empty.
/// Proof. If there are, x u^n v derives words of n letters and more. Conversely, call a letter of a
/// derivation useful if it leaves some letter in the last word. A step makes words longer by at
/// most a constant factor, so in derivations of longer and longer words there are lines of useful
/// letters, from the axiom on and each in the successor of the one before, with more and more
/// branches: steps in which the successor has another useful letter. For two branches at times i <
/// j of a line consider the finishing sets at i and j, the letters of the line at i and j, a useful
/// letter at j that comes of the other letter of branch i, and the relation of all (d, e) such that
/// d derives by the tables between i and j a word with e. There are finitely many such things, so
/// by Ramsey's theorem there are as many branches as wanted of which any two have the same: a set
/// F, a letter a, a letter c, a relation E. Three of them show that E is transitive; (a, a) is in
/// E. The useful c at the second branch is the first of useful letters at the second, third, ...
/// branch, each in relation E to the next; some b is there twice, so (b, b) is in E, and so is (c,
/// b), or c = b and that again. Let u be the tables from the first branch to the third: a derives a
/// and c up to the second, and these derive a and b up to the third; b derives b by (b, b) in E.
/// Let v be the tables from a branch on where b is useful, and x those up to the first. QED
///
/// So it is looked for a way from (F, a, b) to (F, a, b, b) in the graph of finishing sets with two
/// letters while the first two courses are one, with three afterwards. There is one if and only if
/// such a pair is in one strongly connected component once all edges back from (F, a, b, b) to (F,
/// a, b) are added: ways joined by them join up without them. Time and memory: the number of
/// finishing sets (one for T0L systems, at most 2^letters) * letters^3 * tables * the product of
/// the numbers of letters that three letters can become. Throws BoundReached if that takes more
/// than budget.memory.
///
/// Example: !finiteness(et0l("a", {{{'a', "b"}}, {{'b', "aa"}}})).finite
TablesFiniteness finiteness(const ET0L& system, const Budget& budget = {});

}  // namespace algae
