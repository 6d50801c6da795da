#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace algae {

/// Where a walk on the square grid leaves a square: one that starts in the middle of the cells with
/// |x| <= r and |y| <= r and steps to each of the four neighbours with chance 1/4 first comes to the
/// border of the square at (r, y), |y| < r, with this chance; by symmetry on all four sides. That is
///
///     1/N sum over odd k of (-1)^((k-1)/2) sin(pi k (y + r) / N) / cosh(a_k N / 2),
///
/// N = 2r and cosh a_k = 2 - cos(pi k / N): the discrete Poisson kernel of a square, by separation
/// of variables (McCrea and Whipple, Random paths in two and three dimensions, 1940). Rounding
/// errors of doubles only. O(1).
///
/// Throws Error unless |y| < r.
///
/// Example: square_exit_chance(1, 0) < 0.2500001
double square_exit_chance(std::int64_t r, std::int64_t y);

/// Draws from the above for r = 1, 2, 4, ..., 2^most, in constant time (the alias method: Walker
/// 1977; Vose 1991).
class SquareExits {
public:
    static constexpr int most = 11;

    struct Step {
        std::int64_t x, y;
    };

    /// The tables, which are made once.
    static const SquareExits& tables();

    /// The step from the middle to the border of the square with r = 2^exponent, from two random
    /// numbers.
    Step at(int exponent, std::uint64_t first, std::uint64_t second) const;

private:
    SquareExits();

    struct Entry {
        std::uint64_t threshold;  // of 62 bits: below it the entry itself, otherwise the other one
        std::uint32_t other;
    };
    std::vector<std::vector<Entry>> tables_;
};

}  // namespace algae
