#pragma once
// The exact lattice that a turtle with rational angles walks on: its directions, and what a part of
// a derivation does to the plane as the value of a monoid, for folds and `product`.

#include <complex>
#include <cstdint>
#include <vector>

#include "exact/exact.hpp"
#include "system/system.hpp"

namespace algae {

enum class Command : unsigned char;  // in the face of this room
struct Drawing;

/// The directions a turtle of one generation can look: multiples of a full turn divided by `order`.
/// A heading is a number of such units, counter-clockwise from +x, taken modulo the order.
///
/// Where angle, start and spin are rational parts of a turn with denominators up to 360, the order
/// is their common denominator (and a multiple of 4), and directions are powers of a root of unity:
/// positions are exact. Rational angles with larger denominators have their directions in a table
/// of doubles, others are rounded to 2^-60 of a turn.
class Compass {
public:
    using Heading = std::int64_t;

    /// The compass of generation n: settings with their defaults, the start turned by n * spin.
    Compass(const Drawing& drawing, std::uint64_t n);

    std::int64_t order() const { return order_; }
    /// Whether directions are exact: the ring of order `order()` is small enough to compute in.
    bool is_exact() const { return exact_; }
    Heading start() const { return start_; }
    /// What + turns by.
    Heading turn() const { return turn_; }
    Heading half() const { return order_ / 2; }
    /// What a command turns by: 0 if it is none of +, - and |.
    Heading turn_of(Command command) const;

    Heading normal(Heading heading) const {
        heading %= order_;
        return heading < 0 ? heading + order_ : heading;
    }
    Heading sum(Heading left, Heading right) const { return normal(left + right); }

    /// The unit vector of a heading.
    std::complex<double> direction(Heading heading) const {
        const auto index = static_cast<std::size_t>(normal(heading));
        return table_.empty() ? computed(normal(heading)) : table_[index];
    }

private:
    std::complex<double> computed(Heading heading) const;

    std::int64_t order_ = 4;
    bool exact_ = true;
    Heading start_ = 0;
    Heading turn_ = 1;
    std::vector<std::complex<double>> table_;
};

/// What a turtle that turns by multiples of 360/m degrees and walks in unit steps does to the plane,
/// exactly: where it ends, how it has turned, how many segments it drew, and how far its drawing
/// reaches in every of the m directions. Motions compose; a branch comes back to where it began.
///
/// Reach in direction k is kept as twice the largest real part of zeta^-k p over drawn points p, an
/// element of Z[zeta_m]; so is every comparison exact. (It is the support function of the convex
/// hull of the drawing, which unions by maximum and moves by rotation and addition.)
class LatticeMotions {
public:
    struct value_type {
        CyclotomicInteger move;
        std::int64_t turn = 0;  // 0..m-1
        Integer segments = 0;
        std::vector<CyclotomicInteger> reach;  // empty if nothing is drawn
        bool operator==(const value_type&) const = default;
    };

    /// With `reaching` false, reach is not worked out: cheaper where only the way matters.
    explicit LatticeMotions(std::int64_t order, bool reaching = true);

    const CyclotomicRing& ring() const { return ring_; }

    //> branch
    value_type one() const { return {ring_.zero(), 0, 0, {}}; }
    void append(value_type& left, const value_type& right) const;
    value_type branch(const value_type& twig) const {
        return {ring_.zero(), 0, twig.segments, twig.reach};
    }
    //< branch

    /// A unit step ahead, with the pen down or up.
    value_type step(bool drawn) const;
    /// A turn by so many units, of any sign.
    value_type turned(std::int64_t units) const;
    /// What a command does; nothing if it neither steps nor turns. Turns are those of the compass, of whose units
    /// `unit` are one of these.
    value_type of(Command command, const Compass& compass, std::int64_t unit = 1) const;

private:
    CyclotomicInteger reach_of(const CyclotomicInteger& point, std::int64_t direction) const;

    CyclotomicRing ring_;
    bool reaching_;
};

}  // namespace algae
