#include "growth/rate.hpp"

#include <algorithm>
#include <ostream>

#include "growth/radicals.hpp"

namespace algae {

namespace {

const Polynomial variable({0, 1});

long longest_coefficient(const Polynomial& value) {
    std::uint64_t longest = 0;
    for (const Integer& x : value.coefficients()) longest = std::max(longest, bit_length(x));
    return static_cast<long>(longest);
}

/// The least multiple of 2^-bits that is not below.
Rational rounded_up(const Rational& value, long bits) {
    const Integer scale = power(Integer(2), static_cast<std::uint64_t>(bits));
    return Rational(ceiling(value * Rational(scale)), scale);
}

/// p(x^step) == value for the largest step, and p.
std::pair<Polynomial, std::size_t> deflated(const Polynomial& value) {
    std::uint64_t step = 0;
    for (std::size_t k = 1; k < value.coefficients().size(); ++k)
        if (!value.coefficients()[k].is_zero()) step = gcd(Integer(step), Integer(k)).to_uint64();
    std::vector<Integer> coefficients;
    for (std::size_t k = 0; k < value.coefficients().size(); k += step) coefficients.push_back(value.coefficients()[k]);
    return {Polynomial(std::move(coefficients)), step};
}

}  // namespace

std::pair<Rational, Rational> largest_root(const Polynomial& value, const Rational& above, long bits) {
    const Polynomial slope = derivative(value);
    const Rational width(1, power(Integer(2), static_cast<std::uint64_t>(bits)));
    Rational x = above;
    for (long working = 64 + bits;; working *= 2) {
        const long precision = working + longest_coefficient(value) + 4 * value.degree();
        for (;;) {
            const Ball here(x, precision);
            const Ball step = value(here) / slope(here);
            if (!step.is_finite()) break;
            // Newton's point is not below the root, so neither is the upper end of its enclosure.
            const Rational next = rounded_up((here - step).upper(), working);
            const bool close = x - next <= width * Rational(1, 8);
            if (next < x) x = next;
            if (!close) continue;
            const Rational low = x - width;
            const auto side = sign(value(Ball(low, precision)));
            if (side && *side <= 0) return {low, x};
            break;
        }
    }
}

Rate::Rate(const Integer& value) : minimal_({-value, 1}), above_(value) {}

Rate::Rate(Polynomial minimal_polynomial, Rational above)
    : minimal_(std::move(minimal_polynomial)), above_(std::move(above)) {}

std::optional<Integer> Rate::integer() const {
    if (degree() != 1) return std::nullopt;
    return -minimal_.coefficient(0);
}

Ball Rate::enclosure(long bits) const {
    if (const auto exactly = integer()) return Ball(*exactly, bits + 64);
    const long precision = bits + 64 + longest_coefficient(minimal_);
    if (degree() == 2) {
        const Integer b = minimal_.coefficient(1), c = minimal_.coefficient(0);
        return (sqrt(Ball(b * b - 4 * c, precision)) - Ball(b, precision)) / Ball(2, precision);
    }
    const auto [low, high] = largest_root(minimal_, above_, bits + 1);
    return hull(Ball(low, precision), Ball(high, precision));
}

std::string Rate::exact() const {
    const auto [core, step] = deflated(minimal_);
    std::string text;
    if (core.degree() == 1) {
        text = to_string(-core.coefficient(0));
    } else if (core.degree() == 2) {
        text = to_string(larger_root(core));
    } else {
        return "the largest real root of " + to_string(minimal_);
    }
    if (step == 1) return text;
    if (core.degree() == 1 && step == 2) return "sqrt(" + text + ")";
    if (core.degree() == 2) text = "(" + text + ")";
    return text + "^(1/" + std::to_string(step) + ")";
}

std::string Rate::decimal(int digits) const {
    if (const auto exactly = integer()) return to_string(*exactly);
    return significant_decimal([this](long bits) { return enclosure(bits); }, digits);
}

std::strong_ordering operator<=>(const Rate& left, const Rate& right) {
    if (left == right) return std::strong_ordering::equal;
    for (long bits = 32;; bits *= 2) {
        const Order order = compare(left.enclosure(bits), right.enclosure(bits));
        if (order == Order::less) return std::strong_ordering::less;
        if (order == Order::greater) return std::strong_ordering::greater;
    }
}

Rate spectral_radius(const std::vector<Factorisation::Power>& factors, const Rational& above) {
    std::vector<Polynomial> candidates;
    Polynomial product = 1;
    for (const auto& [factor, exponent] : factors) {
        if (factor == variable) continue;
        candidates.push_back(factor);
        product *= factor;
    }
    for (long bits = 16; candidates.size() > 1; bits *= 2) {
        const auto [low, high] = largest_root(product, above, bits);
        const long precision = 2 * bits + longest_coefficient(product) + 4 * product.degree();
        const Ball root = hull(Ball(low, precision), Ball(high, precision));
        std::erase_if(candidates, [&](const Polynomial& factor) { return !factor(root).contains(Rational(0)); });
    }
    return Rate(candidates.front(), above);
}

std::ostream& operator<<(std::ostream& out, const Rate& rate) { return out << rate.exact(); }

}  // namespace algae
