#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "base/budget.hpp"
#include "dimension/unfolding.hpp"
#include "exact/integer_matrix.hpp"
#include "exact/polynomial.hpp"

namespace algae {

/// The ways from the beginnings to the ends of the pieces of an unfolding, in the limit and exactly.
///
/// The ways d_k(a) of the words h^k(a) obey d_k(a) = sum of zeta^heading d_(k-1)(b) over the letters
/// b of h(a). If one eigenvalue mu of this map over Z[zeta] outgrows all others, mu^-k d_k(a) has a
/// limit v(a), a piece of level k is mu^k times as large as one of level 0, and the numbers
/// zeta^i v(a) span a lattice over the integers that mu and zeta map to itself (Dekking, Recurrent
/// sets, 1982). Elements are rows of coordinates in a basis of it; two are equal as complex numbers
/// exactly if their coordinates are, because the basis is found in the number field Q(mu, zeta).
class Displacement {
public:
    using Vector = std::vector<std::int64_t>;

    /// Throws Error with the reason where there is no such mu, or none above 1 in size, BoundReached
    /// where the field is too large (a degree above `largest_rank`) or numbers grow too long.
    explicit Displacement(const Unfolding& unfolding, const Budget& budget = {});

    static constexpr std::size_t largest_rank = 64;
    /// Of the matrix over the integers that mu is looked for in.
    static constexpr std::size_t largest_matrix = 256;

    std::size_t rank() const { return basis_.size(); }
    /// mu, to the precision of doubles, and its size.
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
    /// As a complex number, within about 1e-12 of its size and that of its coordinates.
    std::complex<double> value(const Vector& vector) const;

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

}  // namespace algae
