#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "exact/ball.hpp"
#include "exact/integer_matrix.hpp"
#include "exact/polynomial.hpp"

namespace algae {

/// The matrix of multiplication by a root of a monic polynomial.
///
/// Example: companion(Polynomial({-1, -1, 1})) == IntegerMatrix({{0, 1}, {1, 1}})
IntegerMatrix companion(const Polynomial& polynomial);

/// A positive real algebraic integer: a root of a monic polynomial with integer coefficients.
class AlgebraicInteger {
public:
    /// A natural number above 0.
    explicit AlgebraicInteger(const Integer& value);
    /// The positive root of one of the irreducible polynomials that `enclose(bits)` encloses ever more
    /// tightly. Throws BoundReached if 2^16 bits do not tell it from others.
    AlgebraicInteger(const std::vector<Polynomial>& candidates,
                     const std::function<Ball(long bits)>& enclose);
    /// The largest real root of a monic polynomial, which need not be irreducible; nothing if it has
    /// none above 0.
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

/// By the characteristic polynomial of a power of the companion matrix. Throws BoundReached where
/// degree and exponent multiply to more than 400.
///
/// Example: power(*AlgebraicInteger::largest_root(Polynomial({-2, 0, 1})), 2).integer() == Integer(2)
AlgebraicInteger power(const AlgebraicInteger& base, unsigned exponent);

/// log left / log right, if powers of both with exponents of at most 24 are equal and right is not 1;
/// powers that `power` refuses are not compared.
///
/// Example: exponent_between(AlgebraicInteger(8), AlgebraicInteger(4)) == Rational(3, 2)
std::optional<Rational> exponent_between(const AlgebraicInteger& left,
                                         const AlgebraicInteger& right);

}  // namespace algae
