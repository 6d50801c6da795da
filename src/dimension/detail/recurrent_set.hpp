#pragma once

// The steps from a system to its exact dimension: what its letters do to a turtle, where the parts
// of its recurrent set meet, and how fast the different parts multiply.

#include <bit>
#include <limits>
#include <map>
#include <unordered_map>

#include "dimension/dimension.hpp"

namespace algae {

/// The heading from 0 to order - 1 that is this one.
///
/// Example: normal_heading(-1, 6) == 5
std::int64_t normal_heading(std::int64_t heading, std::int64_t order);

/// The unfolding of a system, with so many times more phases than its turns need. Throws Error with
/// the reason where a turtle's way is not made of exact unit steps and turns: angles that are no
/// rational part of a turn, symbols that change the step, brackets that do not match in every
/// successor, cut branches; BoundReached where turns come back only after more than 10,000 levels.
Unfolding unfolding(const Model& system, const D0L& rules, std::size_t phase_factor = 1);

/// Several eigenvalues outgrow the others together, and more phases may part them.
struct EqualFactors : Error {
    using Error::Error;
};

/// How a piece lies to another one of the same level, seen from the latter: turned and moved, both
/// exactly.
struct Placement {
    std::size_t piece = 0;
    std::int64_t heading = 0;
    Displacement::Vector offset;

    bool operator==(const Placement&) const = default;
    bool operator<(const Placement& other) const {
        if (piece != other.piece) return piece < other.piece;
        if (heading != other.heading) return heading < other.heading;
        return offset < other.offset;
    }
};

/// Whether the discs of a piece and of one placed so come together. Where they do, it says so; discs
/// that lie apart by a hair may be said to come together.
bool may_meet(const RecurrentSet& set, std::size_t piece, const Placement& other);

/// The neighbours of pieces within one component of a recurrent set: all ways in which two pieces
/// of one level, different ones or the same one reached twice, can lie to each other so that they
/// meet. Two pieces meet exactly if there is an infinite path from their pair.
class Neighbours {
public:
    struct Pair {
        std::size_t piece;  // looks along +x from 0
        Placement other;
        std::vector<std::size_t> next;  // pairs of their parts
    };

    /// Throws BoundReached where there are more than `most` pairs, or the budget does not suffice:
    /// then it is not known whether they are finitely many.
    Neighbours(const RecurrentSet& set, std::size_t component, const Budget& budget = {},
               std::size_t most = 50'000);

    /// Pairs that meet; that of a piece with itself stands among them only if two parts coincide.
    const std::vector<Pair>& pairs() const { return pairs_; }
    /// Whether some part is reached in two ways: the open set condition fails.
    bool parts_coincide() const { return coincide_; }
    /// By pair, whether it leads to a coincidence.
    const std::vector<bool>& leads_to_coincidence() const { return critical_; }
    /// The pair of a piece with one placed so, if they meet.
    std::optional<std::size_t> find(std::size_t piece, const Placement& other) const;
    /// The rate at which the pairs of different parts that meet multiply from level to level: that
    /// of the boundary between parts. 1 where none meet.
    Rate meeting_rate(const Budget& budget) const;

private:
    struct Hash {
        std::size_t operator()(const std::pair<std::size_t, Placement>& key) const;
    };
    void leave_out_dead_ends();
    void find_critical();

    std::vector<Pair> pairs_;
    std::vector<std::size_t> starts_;  // the pairs directly within a piece of the component
    std::unordered_map<std::pair<std::size_t, Placement>, std::size_t, Hash> numbers_;
    std::vector<bool> critical_;
    bool coincide_ = false;
};

/// A part of a piece within a component, as it lies where the piece itself lies so: in the units of
/// the level below.
Placement placed(const RecurrentSet& set, const Placement& whole, const RecurrentSet::Part& part);

/// How `other` lies to `first`, seen from it.
Placement seen_from(const RecurrentSet& set, const Placement& first, const Placement& other);

/// The parts of a piece that lie in its own component.
std::vector<RecurrentSet::Part> parts_within(const RecurrentSet& set, std::size_t piece);

/// Whether all of a component's pieces shrink to points.
bool is_point(const RecurrentSet& set, const Component& component);

/// Why there is no dimension of all late generations.
inline constexpr const char
    *vanishing = "what is drawn grows more slowly than what only moves",
    *varying = "late generations are made of other parts than those before and behind";

/// The components whose parts multiply and do not shrink to points, those of the largest rate first, that the axiom leads to in the
/// generations of a phase; for each phase with others than those before. Throws Error where some phase has none.
std::vector<std::vector<std::size_t>> multiplying_components(const RecurrentSet& set);

/// How fast the different parts of a component multiply where parts coincide.
struct DistinctGrowth {
    Rate rate = Rate(1);
    std::size_t kinds = 0;  // of surroundings, that were told apart
    /// How many different parts of each of the first levels the component's first piece has, itself
    /// being that of level 0.
    std::vector<Integer> first_counts;
};

/// The growth of the number of different parts, told apart by their surroundings (Ngai and Wang,
/// Hausdorff dimension of self-similar sets with overlaps, 2001, for sets of finite type); its
/// logarithm over log |mu| is the dimension of the component. Throws BoundReached beyond `most`
/// kinds.
DistinctGrowth distinct_growth(const RecurrentSet& set, std::size_t component,
                               const Neighbours& neighbours, const Budget& budget = {},
                               std::size_t most = 50'000);

/// The rate at which paths multiply that begin so and follow the matrix, whatever they end in.
Rate rate_of_paths(const std::vector<Integer>& start, const GrowthMatrix& matrix,
                   const Budget& budget);

/// The rate divided by a whole number above 0, if that is an algebraic integer.
///
/// Example: quotient(Rate(6), 3) == Rate(2)
std::optional<Rate> quotient(const Rate& rate, const Integer& divisor);

/// `exact_dimension` of a stochastic 0L system. Throws Error where its alternatives do not move the turtle in the same way, or
/// no parts multiply.
ExactDimension random_dimension(const Model& system, const S0L& rules, std::size_t most_ways,
                                const Budget& budget);

/// The cells of a tiling of the plane that a set touches.
struct CellGrowth {
    /// At which those multiply that the set touches and does not cover: those of its boundary.
    Rate boundary = Rate(1);
    bool has_interior = false;  // some cell is covered
    std::size_t kinds = 0;      // of cells, by the parts that meet them
    /// If it was asked for, the area of the set in cells of its lattice lies between these, which are the same where it is known.
    Rational area_low = {}, area_high = {};
};

/// What is asked of the cells beside whether some are covered.
enum class CellQuestion { boundary, area };

/// Of the whole set that the axiom leads to, all components and overlaps of it: log boundary /
/// log |mu| is the dimension of its topological boundary. Throws Error where positions do not lie in
/// a lattice of the plane, BoundReached beyond `most` kinds.
CellGrowth cell_growth(const RecurrentSet& set, const Budget& budget = {},
                       std::size_t most = 50'000);
/// The same of the whole of a set of a lattice of rank 2.
CellGrowth cell_growth(const LatticeSet& set, CellQuestion question, const Budget& budget = {},
                       std::size_t most = 50'000);

/// A disc around discs: the one around the middle of their box.
RecurrentSet::Disc around(const std::vector<RecurrentSet::Disc>& discs);

/// What says which residue modulo M a vector of a lattice of rank 2 is: the vector times the adjoint of M, modulo its determinant.
std::array<std::int64_t, 2> residue(const LatticeSet& set, const LatticeSet::Vector& vector);

/// For each state a disc that holds it, with a margin.
std::vector<RecurrentSet::Disc> discs_of(const LatticeSet& set);

/// Certified bounds. `with_types`: components whose parts meet in few ways are looked at exactly.
DimensionBounds dimension_bounds(const RecurrentSet& set, const BoundsSearch& search,
                                 bool with_types, const Budget& budget);

// Doubles that are not negative, finite, and rounded outward: what is compared with them is proved. A sum
// or a quotient of two doubles is rounded to the nearest one (IEEE 754), so the next one above it is not below the
// number itself, and the next one below it not above it.

static_assert(std::numeric_limits<double>::is_iec559);

/// The least double above one that is not negative.
///
/// Example: next_above(1) == 1 + 0x1p-52
inline double next_above(double value) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) + 1);
}
/// The largest double below a positive one; 0 for 0.
inline double next_below(double value) {
    return value > 0 ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) - 1) : 0;
}

/// No eigenvalue of the matrix with rows of columns, each entry 1, is larger than the first, and where all
/// columns lead to each other, the largest is not below the second: the extremes of the quotients that positive
/// weights give, (sum of weights[column]) / weights[row] (Collatz and Wielandt).
std::pair<double, double> quotients_around(const std::vector<std::vector<std::size_t>>& rows,
                                           const std::vector<double>& weights);

/// By piece, whether it leads in so many generations to one that draws, in each late generation. Throws Error where there are late
/// generations in which it does and others in which it does not, for one limit of all is nothing to speak of then; BoundReached where that is not
/// seen in 10,000 generations. `parts` are the pieces of each piece.
std::vector<bool> drawing_in_all(const std::vector<std::vector<std::size_t>>& parts,
                                 std::vector<bool> draws);

/// By piece, whether it leads to a piece for which this holds, at every later level: where it lies
/// on a cycle of pieces that lead to one, or leads to such a cycle. `parts` are the pieces of each
/// piece.
std::vector<bool> lasting(const std::vector<std::vector<std::size_t>>& parts,
                          const std::vector<bool>& holds);

}  // namespace algae
