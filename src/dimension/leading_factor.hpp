#pragma once

#include <cstdint>
#include <vector>

#include "base/budget.hpp"
#include "base/error.hpp"
#include "dimension/unfolding.hpp"
#include "exact/cyclotomic.hpp"
#include "exact/polynomial.hpp"
#include "growth/complex_ball.hpp"

namespace algae {

/// Several eigenvalues outgrow the others together, and more phases may part them.
struct EqualFactors : Error {
    using Error::Error;
};

/// The eigenvalue mu of the ways of an unfolding that outgrows all others, and the part of the ways
/// that belongs to it.
///
/// M maps ways of one level to those of the next, over Z[zeta]. Over the integers, A = M + t zeta has
/// the eigenvalues sigma(mu') + t sigma(zeta) for all embeddings sigma; with t large enough those with
/// sigma(zeta) = zeta lie together, apart from the others, so mu + t zeta, which generates the field
/// Q(mu, zeta), is found among the roots of the polynomial that annihilates the ways.
class LeadingFactor {
public:
    /// Looks at the pieces marked as moving. Throws what `Displacement` throws.
    LeadingFactor(const Unfolding& unfolding, const std::vector<bool>& moving,
                  const CyclotomicRing& ring, const Budget& budget);

    /// The moving pieces, and the place of one among them.
    const std::vector<std::size_t>& pieces() const { return pieces_; }
    std::size_t place(std::size_t piece) const { return places_[piece]; }

    /// The minimal polynomial q of mu + t zeta.
    const Polynomial& factor() const { return factor_; }
    /// mu + t zeta, and mu itself, to about so many bits.
    ComplexBall root(long bits) const;
    ComplexBall eigenvalue(long bits) const;
    /// A^i u for i from 0 to the degree of q, less one: u is the part of the ways that q annihilates,
    /// times an integer. By place.
    const std::vector<std::vector<CyclotomicInteger>>& powers() const { return powers_; }

private:
    std::vector<CyclotomicInteger> next(const std::vector<CyclotomicInteger>& ways) const;
    Polynomial annihilator_of(const std::vector<CyclotomicInteger>& ways,
                              const Budget& budget) const;
    void choose(const Polynomial& annihilator, std::size_t phases);
    ComplexBall shift(long bits) const;  // t zeta

    CyclotomicRing ring_;
    std::vector<std::size_t> pieces_, places_;
    struct Entry {
        std::size_t place;
        std::int64_t heading;
    };
    std::vector<std::vector<Entry>> rows_;  // of M, by place
    std::size_t widest_ = 0;                // no eigenvalue of M is larger
    long times_ = 0;                        // t
    Polynomial factor_;
    ComplexBall near_{Ball(0, 64), Ball(0, 64)};  // mu + t zeta, apart from the other roots of q
    std::vector<std::vector<CyclotomicInteger>> powers_;
};

}  // namespace algae
