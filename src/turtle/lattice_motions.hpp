#pragma once

#include <cstdint>
#include <vector>

#include "exact/cyclotomic.hpp"

namespace algae {

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
    value_type branch(const value_type& twig) const { return {ring_.zero(), 0, twig.segments, twig.reach}; }
    //< branch

    /// A unit step ahead, with the pen down or up.
    value_type step(bool drawn) const;
    /// A turn by so many units, of any sign.
    value_type turned(std::int64_t units) const;

private:
    CyclotomicInteger reach_of(const CyclotomicInteger& point, std::int64_t direction) const;

    CyclotomicRing ring_;
    bool reaching_;
};

}  // namespace algae
