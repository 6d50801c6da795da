#include "dimension/algebraic_integer.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace algae {

namespace {

constexpr long first_bits = 64, most_bits = 1L << 16;
constexpr long largest_power = 400;  // degree times exponent of which powers are worked out
constexpr long largest_exponent = 24;

/// The real roots, the largest one first.
std::vector<Ball> real_roots(const Polynomial& polynomial, long bits) {
    std::vector<Ball> found;
    for (const Root& root : roots(polynomial, bits))
        if (root.is_real) found.push_back(root.real);
    std::sort(found.begin(), found.end(), [](const Ball& left, const Ball& right) {
        return compare(left, right) == Order::greater;
    });
    return found;
}

bool can_be_raised(const AlgebraicInteger& base, long exponent) {
    const long degree = base.minimal_polynomial().degree();
    return degree == 1 || exponent == 1 || degree * exponent <= largest_power;
}

Ball power_of(const Ball& base, unsigned exponent) {
    Ball result(1, base.bits());
    for (unsigned i = 0; i < exponent; ++i) result *= base;
    return result;
}

}  // namespace

IntegerMatrix companion(const Polynomial& polynomial) {
    const auto degree = static_cast<std::size_t>(polynomial.degree());
    IntegerMatrix matrix(degree, degree);
    for (std::size_t i = 0; i + 1 < degree; ++i) matrix(i + 1, i) = 1;
    for (std::size_t i = 0; i < degree; ++i) matrix(i, degree - 1) = -polynomial.coefficient(i);
    return matrix;
}

AlgebraicInteger::AlgebraicInteger(const Integer& value) : minimal_({-value, Integer(1)}) {}

AlgebraicInteger::AlgebraicInteger(const std::vector<Polynomial>& candidates,
                                   const std::function<Ball(long bits)>& enclose) {
    for (long bits = first_bits; bits <= most_bits; bits *= 2) {
        const Ball number = enclose(bits);
        std::size_t found = 0;
        for (const Polynomial& candidate : candidates) {
            const std::vector<Ball> all = real_roots(candidate, bits);
            for (std::size_t above = 0; above < all.size(); ++above) {
                if (!all[above].overlaps(number)) continue;
                ++found;
                minimal_ = candidate;
                above_ = above;
            }
        }
        if (found == 1) return;
    }
    throw BoundReached(Bound::digits, "a number cannot be told from other roots of polynomials");
}

std::optional<AlgebraicInteger> AlgebraicInteger::largest_root(const Polynomial& polynomial) {
    std::vector<Polynomial> factors;
    for (const auto& [factor, exponent] : factorise(polynomial).powers)
        if (factor.degree() > 0) factors.push_back(factor);
    for (long bits = first_bits; bits <= most_bits; bits *= 2) {
        std::optional<Ball> largest;
        const Polynomial* of = nullptr;
        bool certain = true;
        for (const Polynomial& factor : factors) {
            const std::vector<Ball> all = real_roots(factor, bits);
            if (all.empty()) continue;
            const Order order = largest ? compare(all.front(), *largest) : Order::greater;
            if (order == Order::unknown) certain = false;
            if (order != Order::greater) continue;
            largest = all.front();
            of = &factor;
        }
        if (!certain) continue;
        if (!largest || compare(*largest, Ball(0, bits)) != Order::greater) return std::nullopt;
        return AlgebraicInteger(*of, 0);
    }
    throw BoundReached(Bound::digits, "the largest root cannot be told from others");
}

std::optional<Integer> AlgebraicInteger::integer() const {
    if (minimal_.degree() != 1) return std::nullopt;
    return -minimal_.coefficient(0);
}

Ball AlgebraicInteger::enclosure(long bits) const {
    if (const auto number = integer()) return Ball(*number, bits);
    return real_roots(minimal_, bits).at(above_);
}

AlgebraicInteger power(const AlgebraicInteger& base, unsigned exponent) {
    if (const auto number = base.integer()) return AlgebraicInteger(power(*number, exponent));
    if (exponent == 1) return base;
    if (!can_be_raised(base, exponent))
        throw BoundReached(Bound::digits, "the power " + std::to_string(exponent) +
                                              " of a root of a polynomial of degree " +
                                              std::to_string(base.minimal_polynomial().degree()) +
                                              " is not worked out");
    const IntegerMatrix matrix = companion(base.minimal_polynomial());
    std::vector<Polynomial> factors;
    for (const auto& [factor, times] :
         factorise(characteristic_polynomial(power(matrix, exponent))).powers)
        factors.push_back(factor);
    return AlgebraicInteger(
        factors, [&](long bits) { return power_of(base.enclosure(bits + 64), exponent); });
}

std::optional<Rational> exponent_between(const AlgebraicInteger& left,
                                         const AlgebraicInteger& right) {
    constexpr long bits = 256;
    if (right.integer() == Integer(1)) return std::nullopt;
    if (left.integer() == Integer(1)) return Rational(0);
    const Ball exponent = log(left.enclosure(bits)) / log(right.enclosure(bits));
    const double near = exponent.midpoint();
    for (long b = 1; b <= largest_exponent; ++b) {
        const double a = std::round(near * static_cast<double>(b));
        if (a < 1 || a > largest_exponent) continue;
        const Rational candidate(static_cast<long>(a), b);
        if (!exponent.contains(candidate) || !can_be_raised(left, b) ||
            !can_be_raised(right, static_cast<long>(a)))
            continue;
        if (power(left, static_cast<unsigned>(b)) == power(right, static_cast<unsigned>(a)))
            return candidate;
    }
    return std::nullopt;
}

}  // namespace algae
