#include "dimension/dimension_value.hpp"

namespace algae {

namespace {

/// A number and the k for which it is the k-th root of it, as large as can be seen from the polynomial.
struct Power {
    AlgebraicInteger of;
    long root = 1;
};

/// For a root of p(x^k) the root of p.
Power without_root(const AlgebraicInteger& number) {
    const Polynomial& polynomial = number.minimal_polynomial();
    for (long k = polynomial.degree(); k > 1; --k) {
        std::vector<Integer> coefficients;
        bool fits = true;
        for (long i = 0; i <= polynomial.degree() && fits; ++i) {
            const Integer coefficient = polynomial.coefficient(static_cast<std::size_t>(i));
            if (i % k == 0)
                coefficients.push_back(coefficient);
            else
                fits = coefficient.is_zero();
        }
        if (!fits) continue;
        const auto enclose = [&](long bits) {
            Ball result(1, bits + 64);
            const Ball one = number.enclosure(bits + 64);
            for (long i = 0; i < k; ++i) result *= one;
            return result;
        };
        return {AlgebraicInteger({Polynomial(std::move(coefficients))}, enclose), k};
    }
    return {number, 1};
}

template <class Enclose>
Order by_enclosures(const Enclose& difference) {
    constexpr long enough = digits_compared * 10 / 3 + 8;
    for (long bits = 64; bits <= 2 * enough; bits *= 2)
        if (const auto known = sign(difference(bits)))
            if (*known != 0) return *known < 0 ? Order::less : Order::greater;
    return Order::unknown;
}

}  // namespace

DimensionValue::DimensionValue(const Rational& factor, const AlgebraicInteger& over,
                               const AlgebraicInteger& under) {
    const Power above = without_root(over), below = without_root(under);
    factor_ = factor * Rational(below.root, above.root);
    over_ = above.of;
    under_ = below.of;
}

std::optional<DimensionValue> DimensionValue::of(const LogRatio& ratio) {
    if (const auto value = ratio.rational()) return DimensionValue(*value);
    const auto& square = ratio.ratio().square();
    const auto rate = AlgebraicInteger::largest_root(ratio.rate().minimal_polynomial());
    if (!square || !rate) return std::nullopt;
    return DimensionValue(Rational(2), *rate, *square);
}

std::optional<Rational> DimensionValue::rational() const {
    if (!over_) return factor_;
    const auto exponent = exponent_between(*over_, *under_);
    if (!exponent) return std::nullopt;
    return factor_ * *exponent;
}

Ball DimensionValue::enclosure(long bits) const {
    const Ball factor(factor_, bits);
    if (!over_) return factor;
    return factor * log(over_->enclosure(bits + 16)) / log(under_->enclosure(bits + 16));
}

Order compare(const DimensionValue& left, const DimensionValue& right) {
    const Order order =
        by_enclosures([&](long bits) { return left.enclosure(bits) - right.enclosure(bits); });
    if (order != Order::unknown) return order;
    const auto first = left.rational(), second = right.rational();
    if (first && second) return *first == *second ? Order::equal : Order::unknown;
    if (first || second) return Order::unknown;
    const auto above = exponent_between(*left.over_, *right.over_);
    const auto below = exponent_between(*left.under_, *right.under_);
    if (above && below && left.factor_ * *above == right.factor_ * *below) return Order::equal;
    return Order::unknown;
}

Order compare(const LogRatio& left, const DimensionValue& right) {
    if (const auto value = DimensionValue::of(left)) return compare(*value, right);
    return by_enclosures([&](long bits) { return left.enclosure(bits) - right.enclosure(bits); });
}

}  // namespace algae
