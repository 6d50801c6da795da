#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "exact/exact.hpp"

// Numbers a + b sqrt(d) with rational a and b and a squarefree integer d: the field that one square root makes of the rationals.

namespace algae {

namespace {

QuadraticNumber made(Rational rational, Rational factor, const Integer& radicand) {
    const bool is_rational = factor.is_zero();
    return {std::move(rational), std::move(factor), is_rational ? Integer(1) : radicand};
}

}  // namespace

std::size_t hash_value(const QuadraticNumber& value) {
    std::size_t hash = hash_value(value.rational);
    for (const std::size_t next : {hash_value(value.factor), hash_value(value.radicand)})
        hash = hash * 1'000'003 + next;
    return hash;
}

std::optional<QuadraticNumber> combined(const QuadraticNumber& left, char operation,
                                        const QuadraticNumber& right) {
    if (!left.is_rational() && !right.is_rational() && left.radicand != right.radicand)
        return std::nullopt;
    const Integer& radicand = left.is_rational() ? right.radicand : left.radicand;
    const auto product = [&](const QuadraticNumber& other) {
        return made(
            left.rational * other.rational + left.factor * other.factor * Rational(radicand),
            left.rational * other.factor + left.factor * other.rational, radicand);
    };
    switch (operation) {
        case '+':
            return made(left.rational + right.rational, left.factor + right.factor, radicand);
        case '-':
            return made(left.rational - right.rational, left.factor - right.factor, radicand);
        case '*':
            return product(right);
        default: {
            const Rational norm =
                right.rational * right.rational - right.factor * right.factor * Rational(radicand);
            if (norm.is_zero()) return std::nullopt;
            return product({right.rational / norm, -right.factor / norm, radicand});
        }
    }
}

int sign(const QuadraticNumber& value) {
    const int first = sign(value.rational), second = sign(value.factor);
    if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
    const Rational squares =
        value.rational * value.rational - value.factor * value.factor * Rational(value.radicand);
    return sign(squares) > 0 ? first : second;
}

std::optional<QuadraticNumber> square_root(const Rational& value) {
    const Integer product = value.numerator() * value.denominator();
    const Integer most = 1'000'000'000'000;
    if (product > most || product < 1) return std::nullopt;
    // Every prime up to the cube root of what is left is divided out, so that at most two prime factors remain.
    std::uint64_t rest = product.to_uint64(), outside = 1, inside = 1;
    for (std::uint64_t k = 2; k * k * k <= rest; ++k)
        while (rest % k == 0) {
            const bool is_square = rest % (k * k) == 0;
            rest /= is_square ? k * k : k;
            (is_square ? outside : inside) *= k;
        }
    const auto root =
        static_cast<std::uint64_t>(std::llround(std::sqrt(static_cast<double>(rest))));
    const bool is_square = root * root == rest;
    outside *= is_square ? root : 1;
    inside *= is_square ? 1 : rest;
    const Rational factor = Rational(Integer(outside)) / Rational(value.denominator());
    if (inside == 1) return QuadraticNumber{factor, 0, 1};
    return QuadraticNumber{0, factor, Integer(inside)};
}

Ball enclosure(const QuadraticNumber& value, long bits) {
    if (value.is_rational()) return {value.rational, bits};
    return Ball(value.rational, bits) + Ball(value.factor, bits) * sqrt(Ball(value.radicand, bits));
}

}  // namespace algae
