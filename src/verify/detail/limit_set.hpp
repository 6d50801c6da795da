#pragma once

// The limit set of a D0L system as the steps of its check share it: its lattice, its parts, its components, and numbers
// that dimensions are compared by.

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/exact.hpp"
#include "verify/detail/checking.hpp"
#include "verify/verify.hpp"

namespace algae::verify::limits {

constexpr long bits = 192;

[[noreturn]] inline void too_hard(const std::string& why) {
    throw BoundReached(Bound::method, why);
}

inline bool is_above(const Ball& a, const Ball& b) { return compare(a, b) == Order::greater; }

/// A complex number within two intervals.
struct Number {
    Ball real, imaginary;
};

inline Number number(const Rational& real, const Rational& imaginary = 0) {
    return {Ball(real, bits), Ball(imaginary, bits)};
}
inline Number operator+(const Number& a, const Number& b) {
    return {a.real + b.real, a.imaginary + b.imaginary};
}
inline Number operator-(const Number& a, const Number& b) {
    return {a.real - b.real, a.imaginary - b.imaginary};
}
inline Number operator*(const Number& a, const Number& b) {
    return {a.real * b.real - a.imaginary * b.imaginary,
            a.real * b.imaginary + a.imaginary * b.real};
}
inline Ball square_of_size(const Number& a) { return a.real * a.real + a.imaginary * a.imaginary; }
/// From 0 where it may be 0.
Ball size(const Number& a);
Number operator/(const Number& a, const Number& b);

using Row = std::vector<Integer>;
using Column = std::vector<Number>;

inline void add(Row& left, const Row& right, bool negative = false) {
    for (std::size_t i = 0; i < left.size(); ++i)
        if (negative)
            left[i] -= right[i];
        else
            left[i] += right[i];
}

/// A number that a dimension is made of: base^exponent, or the largest real root of an irreducible polynomial, or
/// one that is only enclosed.
struct Operand {
    std::optional<Integer> base = {};
    Rational exponent = 1;
    Polynomial minimal = {};
    std::function<Ball(long)> enclose = {};
};

/// The largest real root of a polynomial; nothing if it has none above 1, but that 1 itself may be it.
std::optional<Operand> root_of(const Polynomial& polynomial);
/// How two of them compare; `equal` where they are written alike.
Order compared(const Operand& left, const Operand& right);

/// A rational number, or log over / log under.
struct Value {
    std::optional<Rational> number = {};
    std::optional<Operand> over = {}, under = {};

    Ball enclosure(long precision) const;
    std::optional<Rational> rational() const;
};

/// `unknown` where enclosures do not tell and no powers are seen to be equal.
Order compared(const Value& left, const Value& right);

/// Each node by the nodes that it leads to, as often as it does.
using Graph = std::vector<std::vector<std::size_t>>;

/// The strongly connected components of a graph, each node in one.
std::vector<std::vector<std::size_t>> strong_components(const Graph& graph);
/// The largest rate at which paths within a graph multiply: of the strongly connected components, each made smaller by
/// joining nodes that lead equally often to the same ones. Throws BoundReached where one stays too large.
Operand rate_of_paths(const Graph& graph, const Budget& budget);

/// A piece, or a part, of the same level as another one, seen from it.
struct Seen {
    std::size_t piece = 0;
    std::int64_t heading = 0;
    Row offset;

    bool operator<(const Seen& other) const {
        return std::tie(piece, heading, offset) <
               std::tie(other.piece, other.heading, other.offset);
    }
    bool operator==(const Seen& other) const = default;
};

struct Disc {
    Number centre;
    Ball radius;
};

/// Pieces that lead to each other.
struct Component {
    std::vector<std::size_t> pieces;  // in order
    Operand rate;                     // at which their parts multiply
};

/// What is certain of a limit set when the rules and the lattice of the certificate are checked.
struct LimitSet {
    std::int64_t order = 1;
    std::size_t rank = 0, letters = 0,
                phases = 1;  // piece p is letter p % letters in phase p / letters
    IntegerMatrix scale;
    std::vector<IntegerMatrix> turns;                // of rows, by heading
    Number factor = number(1);                       // mu
    Operand ratio;                                   // |mu|
    Column numbers;                                  // that rows stand for
    std::map<std::size_t, std::vector<Seen>> parts;  // of the pieces that draw for ever
    std::vector<Seen> axiom;                         // the pieces of the axiom that do
    std::vector<Component> components;               // that are reached, and whose parts multiply
    std::map<std::size_t, Disc> discs;

    std::int64_t normal(std::int64_t heading) const {
        heading %= order;
        return heading < 0 ? heading + order : heading;
    }
    Row turned(const Row& row, std::int64_t heading) const {
        return row * turns[static_cast<std::size_t>(normal(heading))];
    }
    Number zeta(std::int64_t heading) const {
        const Rational part(2 * heading, order);
        return {cos_pi(part, bits), sin_pi(part, bits)};
    }
    Number value(const Row& row) const;
    Seen seen_from(const Seen& first, const Seen& other) const {
        Row offset = other.offset;
        add(offset, first.offset, true);
        return {other.piece, normal(other.heading - first.heading), turned(offset, -first.heading)};
    }
    bool is_same(std::size_t first, const Seen& other) const {
        return first == other.piece && other.heading == 0 && other.offset == Row(rank);
    }
    /// Those pieces that the axiom leads to.
    std::set<std::size_t> reached() const;
};

/// Reads what a proof says of parts and places.
struct Places {
    const Obligation& task;
    const LimitSet& set;
    std::function<std::size_t(const Field& letter, const Field& phase)> piece_of;

    Row row(const Field& field) const;
    std::int64_t heading(const Field& field) const {
        return static_cast<std::int64_t>(field.number() % static_cast<std::uint64_t>(set.order));
    }
};

/// The parts of the pieces of a component that lie in it.
class Parts {
public:
    Parts(const Places& places, const Component& component);

    const LimitSet& set() const { return places_.set; }
    const Component& component() const { return component_; }
    bool contains(std::size_t piece) const { return inside_.contains(piece); }
    /// As they lie where the whole lies so.
    std::vector<Seen> of(const Seen& whole) const;
    Seen here(std::size_t piece) const { return {piece, 0, Row(set().rank)}; }
    /// Whether no parts of two pieces meet, of some level below: their discs do not.
    bool are_apart(std::size_t first, const Seen& other);
    /// Whether some parts of two pieces are seen to lie in one place, of so many levels below or fewer.
    bool coincide_within(std::size_t first, const Seen& other, std::uint64_t levels);

private:
    static constexpr std::size_t most_looks = 3'000'000;  // at pairs of parts
    static constexpr int deepest = 40;

    bool are_apart(std::size_t first, const Seen& other, int depth);
    bool discs_are_apart(std::size_t first, const Seen& other);

    const Places& places_;
    const Component& component_;
    std::set<std::size_t> inside_;
    std::map<std::pair<std::size_t, Seen>, std::pair<bool, std::uint64_t>>
        known_;  // coincide_within: what is known for how many levels
    std::size_t looks_ = 0;
};

/// All ways in which parts of a component may meet, as a proof lists them: that they are all is checked.
class Neighbours {
public:
    /// Throws Flaw where two parts may meet in another way.
    Neighbours(Parts& parts, const Places& places, const Field& list);

    bool parts_coincide() const { return coincide_; }
    /// Whether parts of both may lie in one place.
    bool may_coincide(std::size_t first, const Seen& other) const;
    /// The rate at which pairs of different parts that meet multiply.
    Operand meeting_rate(const Budget& budget) const;

private:
    using Pair = std::pair<std::size_t, Seen>;

    Parts& parts_;
    std::map<Pair, std::size_t> numbers_;
    Graph next_;                         // by pair; of the pairs within a piece, the last
    std::vector<bool> same_, critical_;  // leads to two parts in one place, at once or later
    bool coincide_ = false;
};

/// Whether parts of two pieces, the second seen from the first, may lie in one place.
using MayCoincide = std::function<bool(std::size_t first, const Seen& other)>;

/// The kinds of parts, by the others that may coincide with parts of them, as a graph whose paths are codes of parts: a
/// part that has several codes keeps the first one of them, in the order of a dictionary, and perhaps more. If everything that
/// coincides is known to, no more: then paths and different parts are as many.
Graph kinds_of_parts(const Parts& parts, const MayCoincide& may_coincide, const Budget& budget);

/// Whether a rate is proved to lie below a number. `image(k, weights)` is, in the place k, the image of weights, that grows
/// with them; the rate is that of repeating it.
bool grows_below(
    std::size_t size, const Rational& number,
    const std::function<std::uint64_t(std::size_t, const std::vector<std::uint64_t>&)>& image,
    const Budget& budget);

/// The rate at which codes multiply whose letters are the different parts of so many levels. Throws BoundReached where there are too many,
/// or where pieces do not all lead to each other in such steps.
Operand rate_of_blocks(const Parts& parts, std::uint64_t levels, const Budget& budget);

/// Whether the dimension of a component is proved to be above a number, by pairs of its parts of so many levels that may lie near each
/// other, in so many cells.
bool is_above_by_pairs(Parts& parts, std::uint64_t levels, std::uint64_t across, const Ball& number,
                       const Budget& budget);

/// The rate at which those cells of a tiling multiply that the boundary of the whole set meets. Throws Flaw where the set has
/// no inner points, BoundReached where its parts lie in no lattice of the plane.
Operand rate_of_boundary(const Places& places);

}  // namespace algae::verify::limits
