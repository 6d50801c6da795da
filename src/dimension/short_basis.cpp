#include "dimension/short_basis.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace algae {

namespace {

/// The complex numbers that the coordinates F(c)_i = c A^i u of a number c stand for: the part of u
/// that belongs to the root of the factor, by Lagrange's interpolation.
std::vector<ComplexBall> trace_dual(const Polynomial& factor, const ComplexBall& root) {
    // factor(x) / (x - root), by Horner's rule from the top, over its value at the root.
    const auto degree = static_cast<std::size_t>(factor.degree());
    const long bits = root.real.bits();
    std::vector<ComplexBall> quotient(degree, {Ball(0, bits), Ball(0, bits)});
    ComplexBall carry{Ball(0, bits), Ball(0, bits)};
    for (std::size_t k = degree; k-- > 0;) {
        carry = carry * root + ComplexBall{Ball(factor.coefficient(k + 1), bits), Ball(0, bits)};
        quotient[k] = carry;
    }
    const ComplexBall slope = value_at(derivative(factor), root);
    for (ComplexBall& coefficient : quotient) coefficient = coefficient / slope;
    return quotient;
}

/// The double as a rational.
Rational rational(double value) {
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    return Rational(Integer(static_cast<std::int64_t>(std::ldexp(fraction, 53)))) *
           power(Rational(2), exponent - 53);
}

}  // namespace

std::vector<std::vector<ComplexBall>> numbers_of(
    const IntegerMatrix& basis, const Polynomial& factor,
    const std::function<std::vector<ComplexBall>(long)>& roots, long digits, const Budget& budget) {
    for (long bits = 256 + digits;; bits *= 2) {
        budget.check();
        if (bits > (1 << 16))
            throw BoundReached(Bound::digits, "the lattice of positions needs too many digits");
        std::vector<std::vector<ComplexBall>> numbers;
        bool certain = true;
        for (const ComplexBall& root : roots(bits)) {
            const auto dual = trace_dual(factor, root);
            auto& of_root = numbers.emplace_back();
            for (std::size_t k = 0; k < basis.rows() && certain; ++k) {
                ComplexBall sum{Ball(0, bits), Ball(0, bits)};
                for (std::size_t i = 0; i < dual.size(); ++i)
                    sum = sum + dual[i] * ComplexBall{Ball(basis(k, i), bits), Ball(0, bits)};
                certain = sum.real.is_finite() && sum.imaginary.is_finite();
                if (!certain) break;
                const double size =
                    std::abs(sum.real.midpoint()) + std::abs(sum.imaginary.midpoint());
                const long exponent =
                    static_cast<long>(std::floor(std::log2(size + 1e-300))) - digits;
                certain =
                    sum.real.has_radius_below(exponent) && sum.imaginary.has_radius_below(exponent);
                of_root.push_back(std::move(sum));
            }
        }
        if (certain) return numbers;
    }
}

namespace {

/// The numbers of a basis with all roots, as integers, to so many bits behind the first of the
/// smallest element.
IntegerMatrix embedded(const IntegerMatrix& basis, const LeadingFactor& leading, long digits,
                       const Budget& budget) {
    const auto all_roots = [&](long bits) {
        std::vector<ComplexBall> all;
        for (const Root& root : roots(leading.factor(), bits))
            all.push_back({root.real, root.imaginary});
        return all;
    };
    const auto numbers = numbers_of(basis, leading.factor(), all_roots, digits + 20, budget);
    double smallest = INFINITY;
    for (std::size_t k = 0; k < basis.rows(); ++k) {
        double size = 0;
        for (const auto& of_root : numbers)
            size +=
                std::abs(of_root[k].real.midpoint()) + std::abs(of_root[k].imaginary.midpoint());
        smallest = std::min(smallest, size);
    }
    const Rational unit = rational(smallest) * power(Rational(2), -digits);
    IntegerMatrix out(basis.rows(), 2 * numbers.size());
    for (std::size_t k = 0; k < basis.rows(); ++k)
        for (std::size_t l = 0; l < numbers.size(); ++l) {
            const auto rounded = [&](const Ball& number) {
                return round_half_even((number / Ball(unit, number.bits())).lower());
            };
            out(k, 2 * l) = rounded(numbers[l][k].real);
            out(k, 2 * l + 1) = rounded(numbers[l][k].imaginary);
        }
    return out;
}

/// One step towards a basis of short elements. Says whether the basis changed.
bool shorten(IntegerMatrix& basis, const LeadingFactor& leading, const Budget& budget) {
    for (long digits = 40;; digits *= 2) {
        if (digits > 20'000)
            throw BoundReached(Bound::digits, "the lattice of positions needs too many digits");
        const IntegerMatrix rows = embedded(basis, leading, digits, budget);
        if (rank(rows) < rows.rows()) continue;
        const IntegerMatrix steps = reducing_matrix(rows);
        basis = steps * basis;
        return steps != IntegerMatrix::identity(basis.rows());
    }
}

}  // namespace

IntegerMatrix short_basis(IntegerMatrix basis, const LeadingFactor& leading, const Budget& budget) {
    constexpr int most_rounds = 50;
    for (int round = 0; round < most_rounds && shorten(basis, leading, budget); ++round) {
    }
    return basis;
}

}  // namespace algae
