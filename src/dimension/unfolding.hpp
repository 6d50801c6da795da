#pragma once
// dimension: the fractal dimension of the curves that systems draw, exact and measured.

#include <cstdint>
#include <vector>

#include "exact/cyclotomic.hpp"
#include "system/d0l.hpp"
#include "system/lsystem.hpp"
#include "turtle/commands.hpp"

namespace algae {

/// What the word h^k(a) of each letter a does to a turtle, level by level, for k large enough that
/// the turns of these words come back regularly: the turn of h^k(a) depends only on a and on k
/// modulo `phases`, from k = `preperiod` on. A letter in a phase is a piece; a piece of one level
/// consists of pieces of the level below, those of the phase before.
///
/// Headings are multiples of a full turn divided by `order`, counter-clockwise; the number is as
/// small as the turns of the system allow.
struct Unfolding {
    /// One after the other what a piece consists of: pieces, and the fences of branches.
    struct Item {
        enum class Kind : unsigned char { piece, push, pop };
        Kind kind = Kind::piece;
        std::size_t piece = 0;
        std::int64_t heading = 0;  // of the turtle where the piece begins
    };

    std::int64_t order = 1;
    std::size_t phases = 1;
    std::uint64_t preperiod = 0;
    std::vector<Symbol> letters;           // piece p is letters[p % letters.size()]
    std::vector<std::vector<Item>> items;  // by piece
    std::vector<std::vector<Item>> paths;  // by piece: those outside branches
    std::vector<std::int64_t> turns;       // by piece: of its word
    std::vector<CyclotomicInteger> moves;  // by piece: of its word of level preperiod + phase
    std::vector<bool> draws;               // by piece: whether the letter itself draws
    std::vector<Item> axiom;               // its letters are pieces of phase 0

    std::size_t size() const { return items.size(); }
};

/// The heading from 0 to order - 1 that is this one.
///
/// Example: normal_heading(-1, 6) == 5
std::int64_t normal_heading(std::int64_t heading, std::int64_t order);

/// The unfolding of a system, with so many times more phases than its turns need. Throws Error with
/// the reason where a turtle's way is not made of exact unit steps and turns: angles that are no
/// rational part of a turn, symbols that change the step, brackets that do not match in every
/// successor, cut branches; BoundReached where turns come back only after more than 10,000 levels.
Unfolding unfolding(const LSystem& system, const D0L& rules, std::size_t phase_factor = 1);

}  // namespace algae
