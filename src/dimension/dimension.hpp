#pragma once

// dimension: the fractal dimension of what systems draw. Exact, from the rules: the curves of a
// system approach a graph-directed self-similar set, and its dimension is the logarithm of the rate
// at which different parts multiply over that of the factor by which they shrink. Measured, with an
// interval: by counting boxes of figures, points and the limit itself, by dividers, by the mass
// within discs, by pairs, by moments of the measure and by gaps.

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "exact/exact.hpp"
#include "growth/growth.hpp"
#include "system/system.hpp"
#include "turtle/turtle.hpp"

namespace algae {

struct Model;

// Numbers that dimensions are made of.

/// A positive real algebraic integer: a root of a monic polynomial with integer coefficients.
class AlgebraicInteger {
public:
    /// A natural number above 0.
    explicit AlgebraicInteger(const Integer& value);
    /// The positive root of one of the irreducible polynomials that `enclose(bits)` encloses ever
    /// more tightly. Throws BoundReached if 2^16 bits do not tell it from others.
    AlgebraicInteger(const std::vector<Polynomial>& candidates,
                     const std::function<Ball(long bits)>& enclose);
    /// The largest real root of a monic polynomial, which need not be irreducible; nothing if it
    /// has none above 0.
    ///
    /// Example: AlgebraicInteger::largest_root(Polynomial({2, -3, 1}))->integer() == Integer(2)
    static std::optional<AlgebraicInteger> largest_root(const Polynomial& polynomial);

    const Polynomial& minimal_polynomial() const { return minimal_; }
    /// The number itself, if it is rational.
    std::optional<Integer> integer() const;
    Ball enclosure(long bits) const;

    bool operator==(const AlgebraicInteger&) const = default;

private:
    AlgebraicInteger(Polynomial minimal, std::size_t above)
        : minimal_(std::move(minimal)), above_(above) {}

    Polynomial minimal_;
    std::size_t above_ = 0;  // how many real roots of it are larger
};

class Displacement;

/// The size of a scaling factor mu, exactly.
class ScalingRatio {
public:
    explicit ScalingRatio(const Displacement& displacement);
    /// A natural number.
    explicit ScalingRatio(const Integer& value);
    /// The square root of a natural number.
    static ScalingRatio square_root(const Integer& square);

    /// |mu|^2, if the degree of mu is at most 12.
    const std::optional<AlgebraicInteger>& square() const { return square_; }
    /// |mu|^2, if it is rational; it is then an integer.
    std::optional<Integer> integer_square() const;
    Ball enclosure(long bits) const;
    /// "3", "sqrt 10", "(1+sqrt(5))/2", otherwise "2.61803, the square root of a root of ...".
    std::string text() const;

private:
    Polynomial factor_;
    std::complex<double> near_;
    std::optional<AlgebraicInteger> square_;
};

/// log rate / log ratio.
class LogRatio {
public:
    LogRatio(Rate rate, ScalingRatio ratio) : rate_(std::move(rate)), ratio_(std::move(ratio)) {}

    const Rate& rate() const { return rate_; }
    const ScalingRatio& ratio() const { return ratio_; }
    /// The number itself, if it is rational and half of it has a numerator and a denominator of at
    /// most 24.
    std::optional<Rational> rational() const;
    Ball enclosure(long bits) const;
    /// "log 4 / log 3", "log 8 / log 4 = 3/2", "log 6 / log sqrt 10",
    /// "log 6 / log ((3+sqrt(5))/2)".
    std::string text() const;
    /// Correctly rounded to so many digits after the point.
    std::string decimal(int digits) const;

private:
    Rate rate_;
    ScalingRatio ratio_;
};

/// log E / log ratio, where parts multiply on average by E: a rate divided by a whole number.
class ExpectedRatio {
public:
    /// Throws Error unless the divisor is above 0.
    ///
    /// Example: ExpectedRatio(Rate(14), 4, ScalingRatio(Integer(3))).text() == "log (7/2) / log 3"
    ExpectedRatio(Rate rate, Integer divisor, ScalingRatio ratio);

    const ScalingRatio& ratio() const { return ratio_; }
    /// E: "7/2", "((1+sqrt(5))/2)/3".
    std::string average() const;
    std::optional<Rational> rational() const;
    Ball enclosure(long bits) const;
    /// "log (7/2) / log 3".
    std::string text() const;
    /// Correctly rounded to so many digits after the point.
    std::string decimal(int digits) const;

private:
    Rate rate_;
    Integer divisor_;  // the least one
    ScalingRatio ratio_;
};

class WayGrowth;

/// The similarity dimension of a graph-directed set with unequal ratios (Mauldin and Williams,
/// Hausdorff dimension in graph directed constructions, 1988): the s for which the matrix of the
/// sums of (|ratio| / m)^s over the parts from each state to each state has the spectral radius 1.
/// For a single state, sum (|ratio| / m)^s = 1 (Moran 1946).
class RatioSum {
public:
    struct Entry {
        std::size_t from, to;
        Expression ratio;
    };

    /// The states must all lead to each other, and have more parts than one. Without a `growth` of the
    /// whole, m = 1: the ratios are those of the parts to the whole. Throws Error where the parts do
    /// not become smaller: no s is large enough.
    RatioSum(std::size_t states, std::vector<Entry> entries,
             std::shared_ptr<const WayGrowth> growth = nullptr);

    /// The strongly connected components of the states, each with the rate at which parts multiply.
    static Components components(std::size_t states, const std::vector<Entry>& entries,
                                 const Budget& budget);
    /// The entries within a component, its states counted from 0.
    static std::vector<Entry> within(const Component& component, const std::vector<Entry>& entries);

    /// With a radius of at most 2^-bits. By bisection: the spectral radius falls as s grows, and is
    /// below 1 exactly if elimination in the unit matrix less this one finds positive pivots only.
    Ball enclosure(long bits) const;
    /// "0.3^s + 2*(0.21^0.5)^s + 0.7^s = m^s with m = 1.06393", where it can be written so: with a
    /// state on all cycles and not too many ways back to it.
    std::string text() const;
    /// Correctly rounded to so many digits after the point.
    std::string decimal(int digits) const;

private:
    std::size_t states_;
    std::vector<Entry> entries_;
    std::shared_ptr<const WayGrowth> growth_;
};

/// A dimension of a self-affine carpet: of a grid of m by n cells, m < n, some are kept, each is made like the whole, and so on. With
/// `lines`, how many cells are kept in each of the m lines where any are (s of them), N in all, the dimension of Hausdorff is
/// log_m of the sum of t^(log_n m) over the lines, that of boxes log_m s + log_n(N / s) (Bedford, Crinkly curves, Markov partitions and
/// box dimensions, 1984; McMullen, The Hausdorff dimension of general Sierpinski carpets, 1984), Assouad's
/// log_m s + log_n max t (Mackay, Assouad dimension of self-affine carpets, 2011), and the lower one the same with the least t
/// (Fraser, Assouad type dimensions and homogeneity of fractals, 2014).
class CarpetDimension {
public:
    enum class Kind { hausdorff, box, assouad, lower };

    /// Throws Error unless 2 <= m < n and there are 1 to m lines of 1 to n cells.
    ///
    /// Example: CarpetDimension(CarpetDimension::Kind::box, 2, 3, {2, 1}).text() == "1 + log (3/2) / log 3"
    CarpetDimension(Kind kind, long m, long n, std::vector<long> lines);

    std::optional<Rational> rational() const;
    Ball enclosure(long bits) const;
    /// "log (1 + 2^(log 2 / log 3)) / log 2" of Hausdorff, "1 + log (3/2) / log 3" of others.
    std::string text() const;
    /// Correctly rounded to so many digits after the point.
    std::string decimal(int digits) const;

private:
    bool is_sum() const;
    Rational in_line() const;  // what log_n is of

    Kind kind_;
    long m_, n_;
    std::vector<long> lines_;  // the largest first
};

/// A dimension as a formula: log rate / log ratio where all parts shrink alike, the solution of an equation between powers where
/// they do not, and sums of logarithms of carpets.
class DimensionFormula {
public:
    DimensionFormula(LogRatio formula) : formula_(std::move(formula)) {}
    DimensionFormula(RatioSum formula) : formula_(std::move(formula)) {}
    DimensionFormula(CarpetDimension formula) : formula_(std::move(formula)) {}
    DimensionFormula(ExpectedRatio formula) : formula_(std::move(formula)) {}

    const LogRatio* log_ratio() const { return std::get_if<LogRatio>(&formula_); }
    const RatioSum* ratio_sum() const { return std::get_if<RatioSum>(&formula_); }

    /// The number itself where it is known to be rational.
    std::optional<Rational> rational() const;
    Ball enclosure(long bits) const;
    std::string text() const;
    /// Correctly rounded to so many digits after the point.
    std::string decimal(int digits) const;

private:
    std::variant<LogRatio, RatioSum, CarpetDimension, ExpectedRatio> formula_;
};

// The exact dimension.

class RecurrentSet;

/// What the rules of a system say of the dimension of its limit curve.
struct ExactDimension {
    enum class Status {
        exact,        // the Hausdorff and, unless there are `others`, the box dimension
        upper_bound,  // of both: some condition could not be verified
        unfinished,   // the letters or the memory of the budget were used up before it was found
        none          // the rules give no formula; `conditions` says why
    };

    Status status = Status::none;
    /// Whether chance has a part in the set: then all is so with probability 1, and of single sets nothing is known.
    bool almost_surely = false;
    std::optional<DimensionFormula> value;
    /// log rate / log |mu|, with multiplicity: where parts coincide it is too large.
    std::optional<DimensionFormula> similarity;
    /// Of the topological boundary of the whole set, where it fills an area; in lattices only.
    std::optional<DimensionFormula> boundary;
    /// The rate at which pairs of parts that meet multiply, where there are finitely many ways.
    std::optional<Rate> meeting;
    /// Whether discs about points of the limit hold as much as their radius to the power of the dimension, up to a factor (Ahlfors
    /// regular), as is proved where all its parts are of one component and none coincide. Then the Assouad and the lower dimension
    /// are the same, and the Hausdorff measure of the dimension is positive and finite (Fraser, Assouad Dimension and Fractal
    /// Geometry, 2020, section 6.4). If false, nothing is known of them.
    bool is_regular = false;
    /// What other dimensions are where they differ from the value: that of boxes is the packing dimension too.
    struct Others {
        DimensionFormula box, assouad, lower;
        std::string measure;  // the Hausdorff measure of the dimension
    };
    std::optional<Others> others;
    /// The parts of the limit, where they were found; its generations can be measured on them.
    std::shared_ptr<const RecurrentSet> limit;
    /// What was verified, or could not be, in sentences.
    std::vector<std::string> conditions;
};

/// The dimension of the recurrent set of a D0L system with a turtle in the plane, as the logarithm
/// of the rate at which parts multiply over that of the factor by which they shrink.
///
/// It is exact if parts meet in finitely many ways: with all parts counted if none coincide,
/// otherwise with the different ones. If these cannot be found within the memory of the budget or
/// by this method, the value with multiplicity is an upper bound. Several components of letters
/// each have their own dimension; the largest is that of the whole.
///
/// A parametric system whose rules multiply all lengths by the same constant is treated in the same
/// way. With several constants, or an angle of no lattice, the value is the similarity dimension
/// (`RatioSum`): exact where neighbour maps show that no parts coincide, else an upper bound.
/// Segments that stay segments have the dimension 1.
///
/// Of a stochastic 0L system whose alternatives move the turtle in the same way it is the dimension of the random set with
/// probability 1, the logarithm of the rate at which parts multiply on average over that of the factor (random_set.cpp).
///
/// At most so many ways in which parts meet are looked at, and kinds of parts. Throws BoundReached past
/// the deadline, Interrupted: neither says anything about the rules.
///
/// Example: exact_dimension(read_lsystem("axiom F; F -> F+F--F+F; angle 60", "")).value->text() == "log 4 / log 3"
ExactDimension exact_dimension(const Model& system, const Budget& budget = {},
                               std::size_t most_ways = 50'000);

/// The same without the search for parts that coincide, which may take long: where it would be
/// needed, the value with multiplicity as an upper bound, and the limit.
///
/// Example: dimension_bound(read_lsystem("axiom F; F -> FF-F-F-F-F-F+F; angle 90", "")).value->text() == "log 8 / log sqrt 10"
ExactDimension dimension_bound(const Model& system, const Budget& budget = {});

/// Certified bounds of the Hausdorff dimension, the upper one also of the box dimension.
struct DimensionBounds {
    Rational low = 0, high = 2;  // rounded outward
    std::string low_by = "no set is smaller", high_by = "as for every set in the plane";

    Rational width() const { return high - low; }
};

/// How far a search for bounds goes.
struct BoundsSearch {
    /// Whether the bounds are near enough, or decide what they are asked for.
    std::function<bool(const DimensionBounds&)> is_enough;
    /// Of the work, which is counted and not timed, so that the bounds are the same on every machine;
    /// 10^9 steps take some 10 seconds.
    std::uint64_t steps = 40'000'000'000;

    /// Until the bounds are at most so far apart.
    static BoundsSearch until_within(const Rational& width) {
        return {[width](const DimensionBounds& found) { return found.width() <= width; }};
    }
};

/// Bounds of the dimension of the recurrent set of a D0L system, also where it has no formula. From
/// above by the number of different parts of a level, from below by the pairs of parts of a level
/// that may meet (`dimension_bounds.cpp`): both tend to the dimension where parts do not crowd. Ends
/// when the search says so, or when its steps or the budget's time are used up.
///
/// Throws what RecurrentSet throws where the system has none, and Error if it is not a D0L system.
DimensionBounds dimension_bounds(const Model& system, const BoundsSearch& search,
                                 const Budget& budget = {});

// Dimensions as numbers to compare with, and ratios as expressions.

/// A number that dimensions are compared with: a rational one, or a rational multiple of
/// log a / log b.
class DimensionValue {
public:
    DimensionValue(const Rational& value) : factor_(value) {}
    /// factor * log over / log under, over at least 1 and under above 1.
    DimensionValue(const Rational& factor, const AlgebraicInteger& over,
                   const AlgebraicInteger& under);
    /// Nothing if the minimal polynomial of |mu|^2 is not known.
    static std::optional<DimensionValue> of(const LogRatio& ratio);

    /// The number itself, if powers of a and b are found to be equal.
    std::optional<Rational> rational() const;
    Ball enclosure(long bits) const;

private:
    friend Order compare(const DimensionValue& left, const DimensionValue& right);

    Rational factor_;
    std::optional<AlgebraicInteger> over_, under_;
};

/// How many digits of both have to agree before two values are not said to be different.
inline constexpr int digits_compared = 200;

/// Exactly where they are equal: two rational numbers, or powers of a and a', and of b and b', that
/// are equal with matching exponents; less or greater where enclosures differ. `unknown` if they
/// agree in 200 digits and there is no such proof. That log a / log b = log a' / log b' needs
/// powers that are equal is not known in general (it follows from Schanuel's conjecture).
///
/// Example: compare(DimensionValue(Rational(1), AlgebraicInteger(8), AlgebraicInteger(4)), Rational(3, 2)) == Order::equal
Order compare(const DimensionValue& left, const DimensionValue& right);

/// The same where the first value may be known by enclosures only.
Order compare(const LogRatio& left, const DimensionValue& right);

/// An expression without names, with every operation on rational numbers done whose result is
/// rational: `0.3*0.7` becomes 0.21, `0.21^0.5` stays. A factor 1 is left out.
///
/// Throws `Diagnostics` where a part has no value.
Expression shortened(Expression expression);

/// The rational number that a shortened expression is, if it is one.
std::optional<Rational> rational_value(const Expression& expression);

/// An enclosure of the value of an expression without names: of + - * / ^, sqrt, exp, log, abs and
/// of sines, cosines and tangents of rational numbers of degrees, beside all that is rational.
///
/// Throws Error for other functions of irrational numbers.
Ball enclosure(const Expression& constant, long bits);

// Exact numbers of the plane: positions and turns by rational numbers of degrees, and square roots
// of rational numbers, lie in the field of the rational numbers and a root of unity.

/// above / below, in lowest terms, so that equal numbers have equal members.
struct CyclotomicNumber {
    CyclotomicInteger above;
    Integer below = 1;

    bool operator==(const CyclotomicNumber&) const = default;
};

/// The field Q(zeta_m). Elements handed to it must be its own; this is not checked.
class CyclotomicField {
public:
    /// Throws `Error` unless 1 <= order <= CyclotomicRing::largest_order.
    explicit CyclotomicField(long order) : ring_(order) {}

    long order() const { return ring_.order(); }
    std::size_t degree() const { return ring_.degree(); }

    CyclotomicNumber rational(const Rational& value) const;
    /// zeta^exponent.
    CyclotomicNumber zeta(std::int64_t exponent) const;
    /// e^(i degrees), if it lies in the field.
    std::optional<CyclotomicNumber> direction(const Rational& degrees) const;
    /// The square root that is not negative, or a positive multiple of i; nothing if it does not lie
    /// in the field, or is not seen to.
    std::optional<CyclotomicNumber> square_root(const Rational& value) const;
    /// The value of an expression without names: of rational numbers, + - * /, integral powers,
    /// square roots of what is rational, sines, cosines and tangents of rational degrees. Nothing
    /// if some part of it is of another kind or lies outside the field.
    std::optional<CyclotomicNumber> value_of(const Expression& constant) const;

    CyclotomicNumber sum(const CyclotomicNumber& left, const CyclotomicNumber& right) const;
    CyclotomicNumber difference(const CyclotomicNumber& left, const CyclotomicNumber& right) const;
    CyclotomicNumber product(const CyclotomicNumber& left, const CyclotomicNumber& right) const;
    CyclotomicNumber conjugate(const CyclotomicNumber& value) const;
    /// Throws Error for 0.
    CyclotomicNumber inverse(const CyclotomicNumber& value) const;
    bool is_zero(const CyclotomicNumber& value) const;
    /// The number, if it is rational.
    std::optional<Rational> as_rational(const CyclotomicNumber& value) const;
    /// Within about 1e-15 of its size.
    std::complex<double> to_complex(const CyclotomicNumber& value) const;
    /// How two real numbers compare.
    std::weak_ordering compare(const CyclotomicNumber& left, const CyclotomicNumber& right) const;

private:
    CyclotomicNumber lowest(CyclotomicInteger above, Integer below) const;

    CyclotomicRing ring_;
};

/// The least m, a multiple of 4, such that Q(zeta_m) has the values of all these expressions; of what
/// `CyclotomicField::value_of` does not know, nothing is asked. Nothing beyond the largest order.
///
/// With nothing asked for, 4.
std::optional<long> cyclotomic_order(const std::vector<const Expression*>& constants);

// The parts of the limit: for those who draw it or write it down in another way.

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

/// The ways from the beginnings to the ends of the pieces of an unfolding, in the limit and
/// exactly.
///
/// The ways d_k(a) of the words h^k(a) obey d_k(a) = sum of zeta^heading d_(k-1)(b) over the
/// letters b of h(a). If one eigenvalue mu of this map over Z[zeta] outgrows all others, mu^-k
/// d_k(a) has a limit v(a), a piece of level k is mu^k times as large as one of level 0, and the
/// numbers zeta^i v(a) span a lattice over the integers that mu and zeta map to itself (Dekking,
/// Recurrent sets, 1982). Elements are rows of coordinates in a basis of it; two are equal as
/// complex numbers exactly if their coordinates are, because the basis is found in the number field
/// Q(mu, zeta).
class Displacement {
public:
    using Vector = std::vector<std::int64_t>;

    /// Throws Error with the reason where there is no such mu, or none above 1 in size,
    /// BoundReached where the field is too large (a degree above `largest_rank`) or numbers grow
    /// too long.
    explicit Displacement(const Unfolding& unfolding, const Budget& budget = {});

    static constexpr std::size_t largest_rank = 64;
    /// Of the matrix over the integers that mu is looked for in.
    static constexpr std::size_t largest_matrix = 256;

    std::size_t rank() const { return basis_.size(); }
    /// mu, off by at most 2^-52 of its size, and its size.
    std::complex<double> factor() const { return factor_; }
    double ratio() const { return std::abs(factor_); }
    /// The minimal polynomial of mu.
    const Polynomial& factor_polynomial() const { return polynomial_; }

    /// v of a piece; all 0 where it is nothing beside mu^k.
    const Vector& way(std::size_t piece) const { return ways_[piece]; }
    Vector zero() const { return Vector(rank(), 0); }
    /// mu times the vector. All three throw BoundReached where coordinates leave 64 bits.
    Vector scaled(const Vector& vector) const { return product(vector, scale_); }
    /// zeta^heading times the vector.
    Vector turned(const Vector& vector, std::int64_t heading) const;
    void add(Vector& left, const Vector& right) const;
    void subtract(Vector& left, const Vector& right) const;
    /// As a complex number, off by at most `error(vector)`; in a frame that is the same for all.
    std::complex<double> value(const Vector& vector) const;
    double error(const Vector& vector) const;

private:
    using Matrix = std::vector<Vector>;  // by rows

    static Vector product(const Vector& row, const Matrix& matrix);

    std::int64_t order_;
    std::complex<double> factor_;
    Polynomial polynomial_;
    std::vector<std::complex<double>> basis_;
    Matrix scale_;
    std::vector<Matrix> turns_;  // by heading
    std::vector<Vector> ways_;   // by piece
};

/// The set that the curves of a system approach when each generation is drawn as large as the one
/// before (Dekking, Recurrent sets, 1982): a graph-directed self-similar set whose pieces K_a, one
/// for each letter and phase that draws for ever, satisfy
///
///     mu K_a = union over the parts of a of zeta^heading K_part + offset.
///
/// All similarities have the ratio 1/|mu|. Offsets are exact.
class RecurrentSet {
public:
    struct Part {
        std::size_t piece;
        std::int64_t heading;
        Displacement::Vector offset;
        bool operator==(const Part&) const = default;
    };
    /// A disc that holds a piece that begins at 0 and looks along +x, which is proved.
    struct Disc {
        std::complex<double> centre;
        double radius = 0;
    };

    /// Throws what `Unfolding` and `Displacement` throw; tries more phases where scaling factors
    /// are equally large.
    RecurrentSet(const Model& system, const D0L& rules, const Budget& budget = {});

    const Unfolding& unfolding() const { return unfolding_; }
    const Displacement& displacement() const { return displacement_; }
    std::int64_t order() const { return unfolding_.order; }
    std::size_t size() const { return parts_.size(); }

    /// The parts of a piece that draw for ever; none for a piece that does not.
    const std::vector<Part>& parts(std::size_t piece) const { return parts_[piece]; }
    const Disc& disc(std::size_t piece) const { return discs_[piece]; }
    /// zeta^heading, off by at most 2^-52.
    std::complex<double> direction(std::int64_t heading) const;
    /// The pieces of the axiom that draw for ever.
    const std::vector<Part>& axiom() const { return axiom_; }
    /// The strongly connected components of the pieces, with the rates at which they multiply.
    const Components& components() const { return components_; }
    /// Whether a piece occurs in what the axiom becomes.
    bool is_reached(std::size_t piece) const { return reached_[piece]; }

private:
    RecurrentSet(std::pair<Unfolding, Displacement> parts, const Budget& budget);
    std::vector<Part> walked(const std::vector<Unfolding::Item>& items,
                             const std::vector<bool>& lasting) const;
    void find_reached();
    void find_discs();
    bool hold(const std::vector<Disc>& discs) const;

    Unfolding unfolding_;
    Displacement displacement_;
    std::vector<std::vector<Part>> parts_;
    std::vector<Part> axiom_;
    std::vector<std::complex<double>> directions_;
    std::vector<Disc> discs_;
    std::vector<bool> reached_;
    Components components_;
};

/// What others need to see the dimension of a recurrent set again: its lattice, and how the parts lie
/// apart in a component that multiplies the fastest. Vectors are rows.
struct LimitWitness {
    struct Piece {
        Symbol letter;
        std::size_t phase;
        Displacement::Vector way;
        bool draws = false;         // for ever
        RecurrentSet::Disc disc{};  // if so; in units of the first element of the basis
    };
    struct Pair {
        std::size_t piece, other;
        std::int64_t heading;
        Displacement::Vector offset;
    };

    std::int64_t order = 1;
    std::size_t phases = 1;
    std::complex<double> factor;
    std::vector<Displacement::Vector> scale, turn;  // the matrices of mu and zeta
    std::vector<Piece> pieces;
    std::size_t component = 0;  // a piece of it
    /// All ways in which its parts may meet; nothing where only the upper bound is seen.
    std::optional<std::vector<Pair>> neighbours;
};

/// Of an exact dimension with all parts counted, or of an upper bound; nothing for others, or where
/// parts meet in more than 5,000 ways.
std::optional<LimitWitness> limit_witness(const ExactDimension& found, const Budget& budget = {});

// Tiles: sets with area whose parts lie in a lattice.

/// A graph-directed set whose parts are moved by vectors of a lattice, and that one linear map makes larger: with M that map,
///
///     M K_s = union over the parts of s of K_state + vector.
///
/// Parts that are turned or reflected have states of their own. The lattice has the rank 2, or the rank 3 and lies densely in
/// the plane, as that of the fractals of Pisot substitutions does. What follows from the vectors is exact; places in the plane
/// say which parts lie far apart.
struct LatticeSet {
    using Vector = std::array<std::int64_t, 3>;  // coordinates; the third is 0 where the rank is 2
    struct Part {
        std::size_t state = 0;
        Vector by{};
        bool operator==(const Part&) const = default;
        friend bool operator<(const Part& left, const Part& right) {
            return left.state != right.state ? left.state < right.state : left.by < right.by;
        }
    };

    std::size_t rank = 2;
    std::array<Vector, 3> scale{};         // M times the unit vectors
    std::array<Point, 3> places{};         // of the unit vectors
    std::array<double, 4> linear{};        // M itself: (x, y) to (l0 x + l1 y, l2 x + l3 y)
    std::vector<std::vector<Part>> parts;  // by state
    std::vector<std::size_t> shapes;       // by state: those with the same number are congruent
    std::vector<Part> whole;
    /// The square of the area of a cell of the lattice, where it is known, and in which unit.
    std::optional<Rational> cell_square;
    std::string unit;
    /// Vectors by which the whole, moved, tiles the plane, where that is known.
    std::optional<std::array<Vector, 2>> periods;

    Vector scaled(const Vector& vector) const;
    Point place(const Vector& vector) const;
    /// How many times as large areas become. Of the rank 2 only.
    std::int64_t determinant() const;
};

/// The recurrent set as one of a lattice, in the square of the distance from its beginning to its end. Throws Error where positions
/// do not lie in a lattice of the plane, BoundReached where coordinates need too many digits.
LatticeSet lattice_set(const RecurrentSet& set, const Budget& budget = {});

/// The dimension of the topological boundary of a set of a lattice of rank 2 that has inner points: log r / log |M|, with r the rate
/// at which the cells multiply that it touches and does not cover (`lattice_cells.cpp`). Nothing where it has none.
///
/// Throws Error for the rank 3 and where M is no similarity, BoundReached beyond `most` kinds of cells.
std::optional<LogRatio> boundary_dimension(const LatticeSet& set, const Budget& budget = {},
                                           std::size_t most = 50'000);

/// What is known of a set as a tile.
struct Tile {
    enum class Answer { yes, no, undecided };
    struct Finding {
        Answer answer = Answer::undecided;
        std::string because;  // the theorem, or what is missing
    };

    /// The area in cells of the lattice, or of the periods: 0 where the set is without inner points. Where it is not known, bounds
    /// that are proved.
    std::optional<Rational> cells;
    std::optional<std::pair<Rational, Rational>> cells_between;
    /// The square of the area in the unit of the set, where both are known.
    std::optional<Rational> area_square;
    std::string unit;
    /// Whether it is the closure of its inner points and parts of each level overlap in sets of the area 0, and why not.
    Finding is_tile;
    /// Of the tiling that the set makes when it is enlarged again and again: of how many tiles a tile of its kind has one point or more
    /// in common, at least and at most. Of a set with periods, of the periodic tiling.
    std::size_t least_neighbours = 0, most_neighbours = 0;
    /// One full set of neighbours of the whole; those of a set with periods by the vector, each with all parts.
    std::vector<LatticeSet::Part> neighbours;
    bool is_periodic = false;  // a lattice tiling
    /// What was looked at: without the parts of the area 0 that lie in others. Neighbours are states of it.
    LatticeSet set;
    Finding connected, disk_like, interior_connected;
    Finding infinitely_many;  // components of the interior
};

/// Whether the set is a tile, and what it looks like (`tile.cpp` names the theorems). Nothing is said that is not proved; where
/// there are more than `most` ways in which parts meet, it is not decided. O(ways^3) at worst for the area, else about linear.
///
/// Throws BoundReached only past the deadline or the memory, Interrupted.
Tile tile(const LatticeSet& set, const Budget& budget = {}, std::size_t most = 50'000);

/// "1/2", "sqrt(3)/6": the square root of a rational number.
///
/// Example: square_root_text(Rational(3, 36)) == "sqrt(3)/6"
std::string square_root_text(const Rational& square);

/// The outlines of a tile and of its neighbours, as polygons with sides along the axes: the pixels of a grid with about
/// `across` columns for the tile, each of which belongs to one of them. The tile comes first.
std::vector<std::vector<Point>> tile_outlines(const Tile& of, std::size_t across,
                                              const Budget& budget = {});

// Boxes: what is counted, and what the counts say.

/// The first `count` places of a sequence that fills the unit square evenly (Roberts 2018:
/// multiples of the powers of the plastic number, modulo 1), for offsets of grids. The same on
/// every machine.
///
/// Example: even_offsets(1)[0].x > 0.5
std::vector<Point> even_offsets(std::size_t count);

/// How wide cells are: `count` scales, the first one `coarsest`, each one `ratio` times finer than
/// the one before.
struct BoxScales {
    double coarsest = 1;
    double ratio = 2;
    std::size_t count = 12;

    double cell(std::size_t scale) const;
};

/// Scales with the longer side of the box as the coarsest one. Throws Error if the box is empty,
/// is one point only, or goes beyond the range of numbers.
///
/// Example: scales_of(Box{{0, 0}, {4, 1}, false}, 2, 12).cell(11) == 4.0 / 2048
BoxScales scales_of(const Box& box, double ratio, std::size_t count);

/// The numbers of cells that something touches, for every scale and every offset of the grid.
struct BoxCounts {
    BoxScales scales;
    /// Of each scale, coarsest first: one number for each offset.
    std::vector<std::vector<std::uint64_t>> counts;
    /// The size of the smallest detail: the length of a segment, the side of a pixel; 0 if the
    /// thing measured has none. Finer cells see lines or points, not the shape.
    double detail = 0;
    /// What was counted, with multiplicity, and what one of them is called.
    std::uint64_t parts = 0;
    /// The longer side of the whole; 0 if it is the coarsest cell.
    double whole = 0;
    std::string part = "segment";
    /// The dimension of the space it lies in, which no dimension exceeds.
    int space = 2;
    /// The standard deviation of noise that points are seen to have, finer cells than a dozen of which see the noise; 0 if none is.
    double noise = 0;

    /// The mean over the offsets.
    double mean(std::size_t scale) const;
};

/// Counts the cells that the segments of a figure touch, by going from cell to cell along each
/// segment (Amanatides and Woo 1987), never by a raster. Cells are half-open squares, so that what
/// runs along a border is counted once. Of polygons, the outlines are counted.
///
/// `offsets` move each grid against the figure's lower left corner, in shares of the coarsest cell;
/// for ratios other than 2, of the scale's own cell. With ratio 2 only the finest scale is counted
/// from segments: a square of 2 by 2 cells is touched where one of them is. All offsets are counted
/// in one pass over the figure. O(segments * offsets) time for ratio 2, * scales for others; memory
/// for the bits of the finest cells, at most budget.memory.
///
/// Throws Error if nothing is drawn, BoundReached, Interrupted.
BoxCounts box_counts(const Figure& figure, const BoxScales& scales, std::span<const Point> offsets,
                     const Budget& budget);

/// Points of a line, of the plane or of space.
struct PointSet {
    int columns = 2;  // coordinates of a point, 1 to 3; the others are 0
    std::vector<std::array<double, 3>> points;
    /// The size of a point, where it has one (the side of a pixel); otherwise 0.
    double detail = 0;
    /// What one of them is called.
    std::string part = "point";
};

/// The points in a text: one a line, 1 to 3 numbers with commas, semicolons or white space between
/// them. Empty lines and what follows # are skipped, and a first line of names. `name` is what
/// messages call the text.
///
/// Throws Diagnostics, with line and column, where something else stands; Error if there are no
/// points.
///
/// Example: read_points("x, y\n0, 0.5\n1 -2e3\n", "two.csv").points[1][1] == -2000
PointSet read_points(std::string_view text, const std::string& name);

/// The dots of a figure that is nothing but dots, such as a chaos game or an attractor, in drawing order; nothing if it draws something
/// that has a length, or nothing at all. 24 bytes a dot.
///
/// Throws BoundReached if the dots need more memory than the budget has, Interrupted.
std::optional<PointSet> dots_of(const Figure& figure, const Budget& budget);

/// The box around the points, as a range for each column; its longest side.
///
/// Throws Error if all points are the same.
double longest_side(const PointSet& points);

/// Counts the half-open cells that hold a point, for `count` dyadic scales from the longest side
/// downward and so many offsets of the grid. Cells are intervals, squares or cubes. `parts` is the
/// number of different points. O(points * log(points) * offsets) time, 32 bytes a point; at most 20
/// scales.
///
/// Throws Error if all points are the same or there are too many scales, BoundReached, Interrupted.
BoxCounts box_counts(const PointSet& points, std::size_t count, std::size_t offsets,
                     const Budget& budget);

/// A number that was measured, and the interval in which the true one is expected.
struct Estimate {
    double value = 0, low = 0, high = 0;
};

/// What box counts say of the dimension of the shape that a figure, an image or points stand for.
struct BoxFit {
    /// Between each scale and the next finer one: how fast the mean count grows with 1 / cell.
    std::vector<double> slopes;
    /// The scales that were used: those from `first` to `last`, both included.
    std::size_t first = 0, last = 0;
    /// Nothing if there are too few of them.
    std::optional<Estimate> estimate;
    /// The line through these scales in the plot: the mean count of scale j is about
    /// exp(intercept) / cell^slope + boundary * rate^j; it is straight without a boundary.
    double slope = 0, intercept = 0;
    double boundary = 0, rate = 1;
    /// Which scales and why, in one sentence; or why nothing can be said.
    std::string because;

    /// The natural logarithm of the mean count that the line gives for a scale.
    double fitted(const BoxCounts& counts, std::size_t scale) const;
    /// How far the logarithm of the mean count is above the line.
    double residual(const BoxCounts& counts, std::size_t scale) const;
};

/// Fits the dimension. Scales are used that are at most an eighth of the whole, so that its outer
/// shape does not decide, and at least four details (segments, pixels) wide; for points, which have
/// no size, as long as eight points fall into a cell on average. Of these, the seven finest.
///
/// The estimate is the slope over these scales; where the local slopes rise from scale to scale,
/// what they tend to if the rises go on shrinking as they do. The interval holds all local slopes
/// and what their trend adds once more; and upward, because counts of a finite generation are too
/// low rather than too high, 4.5 / slopes of their range and 1/20 of detail / finest cell. It is
/// not a standard error: those of a regression on counts are far too small. tests/dimension
/// measures how often it holds the true value over random curves. O(scales * offsets).
///
/// With fewer than four scales to use, there is no estimate, and `because` says what would help.
/// Pictures have a fit of their own, `fit_picture`.
BoxFit fit_dimension(const BoxCounts& counts);

/// How many cells of square grids a recurrent set K touches, itself and not some generation of it.
///
/// Scale j counts the unit cells that mu^(j levels) K touches, so that every scale shows the same
/// set in the same direction: without the wobble of other ratios. Cells are in parts of the longer
/// side of the set.
struct LimitCounts {
    BoxCounts boxes;
    std::size_t levels = 1;  // generations from one scale to the next
};

/// How the limit is counted.
struct LimitCounting {
    std::size_t places = 16;             // of the grid, moved and turned at random
    std::uint64_t seed = 1;              // of the places
    std::uint64_t most_cells = 400'000;  // touched in the finest scale, about
    bool coinciding = false;             // parts coincide: each is looked at once in a place
};

/// What is measured on the limit that the rules lead to.
struct LimitMeasure {
    LimitCounts counts;
    BoxFit fit;
};

/// Counts and fits with what is known exactly: `exact.limit` must be there. Where parts coincide,
/// which costs more for each cell, half as many cells are touched.
LimitMeasure measure_limit(const ExactDimension& exact, LimitCounting counting,
                           const Budget& budget = {});

// Other measures of figures and of points.

/// A measure at several scales, and what its growth with the scale says of the dimension.
struct Scaling {
    std::vector<double> sizes;   // of openings, radii, cells; each half of the one before
    std::vector<double> values;  // of the measure, one for each size
    /// Between each size and the next finer one: the dimension that their two values give.
    std::vector<double> slopes;
    /// The scales that were used: those from `first` to `last`, both included.
    std::size_t first = 0, last = 0;
    /// Nothing if there are too few of them.
    std::optional<Estimate> estimate;
    /// Which scales and why, in one sentence; or why nothing can be said.
    std::string because;
    /// The standard deviation, in each coordinate, of noise that points are seen to have; 0 if none is seen.
    double noise = 0;
};

/// A polyline: the points that it joins, in order.
using Stroke = std::vector<Point>;

/// The lengths that dividers of several openings find (Richardson 1961; Mandelbrot, How long is the
/// coast of Britain?, Science 156, 1967): opening times steps, so that dimension = 1 - slope. Each
/// stroke is walked from eight of its points to both of its ends, and the mean taken. Openings are
/// an eighth of the widest stroke and its halves down to `detail`, the length of a segment; used
/// are those of at least four. Strokes less wide than the widest opening are left out, which
/// `because` says. O(points * openings).
///
/// Throws Error if there is no stroke wider than a point, BoundReached, Interrupted.
Scaling divider(const std::vector<Stroke>& strokes, double detail, const Budget& budget);

/// The same of the strokes of a figure.
Scaling divider(const Figure& figure, const Budget& budget);

/// From how many places, and which.
struct Sandboxes {
    std::size_t centres = 500;
    std::uint64_t seed = 1;
};

/// The mean length of what a figure draws within discs around random places on it (the sandbox
/// method: Tel, Fueloep and Vicsek, Physica A 159, 1989): it grows as the radius to the power of
/// the dimension, that of correlation where parts of the figure differ in density. What is drawn
/// twice counts twice. Radii are an eighth of the whole and its halves down to the length of a
/// segment, of which those of at least four segments are used. The figure is drawn three times and
/// not kept. O(segments * centres) time.
///
/// Throws Error if nothing is drawn or there are no centres, BoundReached, Interrupted.
Scaling mass(const Figure& figure, const Sandboxes& sandboxes, const Budget& budget);

/// The mean number of other points within balls around random points of the set; used are radii
/// that hold at least four on average. Noise is seen as by `correlation`. O(points * centres).
///
/// Throws Error if all points are the same or there are no centres, Interrupted.
Scaling mass(const PointSet& points, const Sandboxes& sandboxes, const Budget& budget);

/// How many points stand for the set, and which.
struct CorrelationSample {
    std::size_t points = 20'000;
    std::uint64_t seed = 1;
};

/// The correlation sum (Grassberger and Procaccia, Physica D 9, 1983): the share of pairs of points
/// that are at most a radius apart, which grows as the radius to the power of the correlation
/// dimension. Of more points than the sample takes, an even sample stands for all. Radii are an
/// eighth of the longest side and its halves; used are those within which a point has at least four
/// others on average.
///
/// Points that are each moved by chance fill the plane below the size of these moves, and lie as before above it. Where the slopes
/// show such a bend, the dimension and the standard deviation of normal noise are those with which the correlation sum, known in closed
/// form (`noisy_correlation` in detail/measures.hpp), comes nearest to the sum found (Schreiber, Determination of the noise level
/// of chaotic time series, Phys. Rev. E 48, 1993).
///
/// Throws Error if there are fewer than two points or all are the same, BoundReached, Interrupted.
Scaling correlation(const PointSet& points, const CorrelationSample& sample, const Budget& budget);

/// The same of points spread evenly along what a figure draws.
Scaling correlation(const Figure& figure, const CorrelationSample& sample, const Budget& budget);

/// The generalised dimension of one order.
struct GeneralisedDimension {
    double order = 0;
    /// The values are the sums of p^order over the boxes, for order 1 the information -sum p log p.
    Scaling scaling;
};

/// The dimensions D_q of Renyi (Hentschel and Procaccia, Physica D 8, 1983) of the length that a
/// figure draws: with p the share of it in a box of side e, sum p^q grows as e^((q - 1) D_q), and
/// sum p log p as D_1 log e, the information dimension. D_0 is the box dimension, with the counts
/// and the estimate of box_counts, not those of pictures; what is drawn twice counts twice in all others.
///
/// For q below 0 a box that the set barely touches, whose p is as small as chance will have it,
/// would outweigh all others. So there p is the share in the box and those around it, a box three
/// times as wide that is never barely touched (Riedi, J. Math. Anal. Appl. 189, 1995): for q above
/// 0 the dimensions are the same, for q below 0 only these are those of the theory.
///
/// Along the edge of a set that fills the plane even those are partly empty: for orders below 0 the
/// value comes out low there, and the interval is wide.
///
/// Boxes are as wide as the whole and its halves down to four segments, in so many grids, one pass
/// each; sums are means over the grids. O((segments + boxes * orders) * offsets).
///
/// Throws Error if nothing is drawn or no order or no offset is given, BoundReached, Interrupted.
std::vector<GeneralisedDimension> generalised_dimensions(const Figure& figure,
                                                         std::span<const double> orders,
                                                         std::size_t offsets, const Budget& budget);

/// The same of points, each with its weight; all have the same if there are no weights. Used are
/// boxes with eight different points on average.
///
/// Throws Error also if there is not one weight, 0 or more, for each point, or all are 0.
std::vector<GeneralisedDimension> generalised_dimensions(const PointSet& points,
                                                         std::span<const double> weights,
                                                         std::span<const double> orders,
                                                         std::size_t offsets, const Budget& budget);

/// A rectangle of square cells of which some are filled. One row of them is a part of a line.
struct CellRectangle {
    std::size_t columns = 0, rows = 0;
    std::vector<bool> filled;  // row after row
    double cell = 1;           // the side of a cell
};

/// Lacunarity for boxes with powers of two as sides. Of a self-similar set it falls as the side to
/// the power of its dimension less that of the space. Used are sides from four cells to an eighth
/// of the rectangle's shorter side.
///
/// Throws Error if there are no cells or none is filled, BoundReached, Interrupted.
Scaling lacunarity(const CellRectangle& cells, const Budget& budget);

/// How many boxes the ink of a picture touches: means over all places of the grid.
struct PictureCounts {
    std::size_t across = 0;          // the longer side of the ink, in pixels
    std::vector<std::size_t> sides;  // of boxes, in pixels: 1, 2, 3, 4, 6, 8, 11 ... `across`
    std::vector<double> boxes;       // for each side
};

/// Counts the boxes for all places of the grid at once, as the pixels of the ink dilated by a square (`picture.cpp`). The
/// rectangle is that around the ink (`filled_cells`). O(pixels * sides) time; 4 bytes a pixel of ink.
///
/// Throws Error if no cell is filled, BoundReached, Interrupted.
///
/// Example: picture_counts({1, 1, {true}, 1}, Budget()).boxes == std::vector<double>{1}
PictureCounts picture_counts(const CellRectangle& ink, const Budget& budget);

/// Fits the dimension of what a picture shows, without what the outer shape adds to coarse boxes and pixels take from fine
/// ones (`picture.cpp`). `shown` are the counts of the plot, to whose scales the fit's slopes and line belong. Of pictures of 224 sets of known
/// dimension, 1,024 pixels wide, half of the values are within 0.015 and 97 % of the intervals hold the dimension. A
/// picture whose ink is less than 96 pixels across has no estimate, and `because` says so. O(sides).
BoxFit fit_picture(const PictureCounts& counts, const BoxCounts& shown);

/// The cells that a figure touches, in the square around it, with at most `most` cells a side and
/// none shorter than a segment. The figure lies in its middle. Throws Error if nothing is drawn.
CellRectangle drawn_cells(const Figure& figure, std::size_t most, const Budget& budget);

/// The cells that hold a point: of points with a size, such as pixels, one for each in the
/// rectangle around them; otherwise in the square, and as small as leaves eight points in a filled
/// cell on average. Throws Error if all points are the same or lie in space, BoundReached.
CellRectangle filled_cells(const PointSet& points, const Budget& budget);

}  // namespace algae
