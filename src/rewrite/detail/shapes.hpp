#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "rewrite/rewrite.hpp"

namespace algae {

/// A size as a rule gives it: a length, or a share of what the lengths leave.
struct PartSize {
    Rational value;
    bool relative = false;
};

/// The lengths into which an extent is cut: absolute ones as they are, a relative one r as
/// r * (extent - sum of the absolute ones) / sum of the relative ones (div with relative sizes).
/// Without relative sizes the lengths may leave a rest, which stays empty. Throws Error if a size
/// is not above 0, if the lengths add up to more than the extent, or if they leave nothing for
/// relative ones.
///
/// Example: lengths_of(10, {{2}, {1, true}, {1, true}, {2}})[1] == 3
std::vector<Rational> lengths_of(const Rational& extent, const std::vector<PartSize>& sizes);

/// How many parts of a size fit into an extent: the greatest whole number not above extent / size
/// (repeat). The parts fill the extent, so each of them is extent / that number long: the size
/// itself where the quotient is whole. Throws Error if the size is not above 0 or above the extent.
///
/// Example: parts_that_fit(10, 3) == 3
Integer parts_that_fit(const Rational& extent, const Rational& size);

/// How far two boxes are apart along an axis: the gap between their extents there, 0 where these
/// overlap or touch, whatever lies between them along the other axes.
///
/// Example: gap({0, {0, 0, 0}, {1, 1, 1}}, {0, {Rational(6, 5), 0, 0}, {1, 1, 1}}, 0) == Rational(1, 5)
Rational gap(const ShapeBox& left, const ShapeBox& right, std::size_t axis);

/// What `distance(X, wall)` means in the condition of a shape rule: along that axis, the gap between
/// the box that is rewritten and the nearest other box of that symbol in the word of the generation
/// that is rewritten. Where there is no other box of the symbol it is infinitely far: more than any
/// number, and an error in sums and products (001 4.3.2).
///
/// So a window's place 0.3 wide, 0.2 away from a wall along X, has no window by the rule
/// `place(x,y,z) : distance(X, wall) > x -> I(window)`.
class NearestBoxes {
public:
    /// For the distances that the system's conditions ask for, each of which gets two sorted rows of
    /// ends: O(n log n) comparisons for n boxes.
    NearestBoxes(const ShapeSystem& system, const std::vector<ShapeBox>& boxes);

    /// The distance of a box of the word from the nearest other one with this symbol, nothing where
    /// there is none; `axis` and `symbol` as some condition asks for them. O(log n) comparisons.
    std::optional<Rational> distance(const ShapeBox& box, std::size_t axis, Symbol symbol) const;

private:
    struct Ends {
        std::vector<Rational> low, high;  // each sorted
    };
    std::map<std::pair<std::size_t, Symbol>, Ends> ends_;
};

}  // namespace algae
