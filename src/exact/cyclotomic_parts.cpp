#include <algorithm>
#include <cmath>

#include "exact/arb.hpp"
#include "exact/cyclotomic_context.hpp"
#include "exact/flint.hpp"

// The parts of a number along a direction: signs, order, enclosures, nearest doubles, decimals.

namespace algae {

namespace {

constexpr double unit_roundoff = 0x1p-53;

/// high + low == left + right exactly (Knuth, The Art of Computer Programming 2, 4.2.2, theorem B).
std::pair<double, double> two_sum(double left, double right) {
    const double sum = left + right;
    const double part = sum - left;
    return {sum, (left - (sum - part)) + (right - part)};
}

}  // namespace

template <class Coefficient>
int CyclotomicRing::Context::sign_by_doubles(CyclotomicDirection direction,
                                             Coefficient coefficient) const {
    // With u = 2^-53, a coefficient has a relative error of u, a cosine an absolute one of u, a
    // product and each of the sums u again: n products are off by less than (n + 8) 2u times the sum
    // of their sizes. An overflow makes every comparison false, which is "not certain".
    double sum = 0;
    double size = 0;
    for_cosines(direction, [&](std::size_t j, std::size_t place) {
        const double c = coefficient(j);
        sum += c * cosines[place].high;
        size += std::abs(c);
    });
    const double bound = size * (static_cast<double>(degree) + 8) * 2 * unit_roundoff;
    return sum > bound ? 1 : sum < -bound ? -1 : 0;
}

int CyclotomicRing::Context::sign(const std::vector<Integer>& value,
                                  CyclotomicDirection direction) const {
    if (const int found =
            sign_by_doubles(direction, [&](std::size_t j) { return value[j].to_double(); }))
        return found;
    const std::vector<Integer> twice = doubled(value, direction);
    if (std::all_of(twice.begin(), twice.end(), [](const Integer& x) { return x.is_zero(); }))
        return 0;
    for (long bits = 128;; bits *= 2)  // ends: the number is not 0
        if (const auto found = algae::sign(enclosure(value, direction, bits))) return *found;
}

std::weak_ordering CyclotomicRing::Context::compare(const std::vector<Integer>& left,
                                                    const std::vector<Integer>& right,
                                                    CyclotomicDirection direction) const {
    if (const int found = sign_by_doubles(
            direction, [&](std::size_t j) { return (left[j] - right[j]).to_double(); }))
        return found <=> 0;
    if (left == right) return std::weak_ordering::equivalent;
    std::vector<Integer> difference = left;
    for (std::size_t j = 0; j < degree; ++j) difference[j] -= right[j];
    return sign(difference, direction) <=> 0;
}

Ball CyclotomicRing::Context::enclosure(const std::vector<Integer>& value,
                                        CyclotomicDirection direction, long bits) const {
    constexpr long kept_bits = 4096;  // beyond, cosines would fill the memory
    Ball sum = ball(bits);
    const std::lock_guard lock(mutex);
    for_cosines(direction, [&](std::size_t j, std::size_t place) {
        if (value[j].is_zero()) return;
        const auto found = precise_cosines.find({bits, place});
        if (found != precise_cosines.end()) {
            arb_addmul_fmpz(arb(sum), arb(found->second), flint(value[j]), bits);
        } else {
            const Ball cosine = cos_pi(Rational(2 * place, turn), bits);
            arb_addmul_fmpz(arb(sum), arb(cosine), flint(value[j]), bits);
            if (bits <= kept_bits) precise_cosines.emplace(std::pair(bits, place), cosine);
        }
    });
    return sum;
}

std::optional<double> CyclotomicRing::Context::nearest_by_pairs(
    std::span<const std::int64_t> value, CyclotomicDirection direction) const {
    // The high parts are added without error, the low parts in double: with u = 2^-53 they are
    // below (n + 3) u times the sum of the sizes and suffer 4n roundings, so the error is below
    // (4n(n + 3) + 16) u^2 times that sum. Twice this covers its own rounding.
    constexpr std::int64_t limit = std::int64_t{1} << 62;
    DoubleDouble sum;
    double size = 0;
    bool is_small = true;
    for_cosines(direction, [&](std::size_t j, std::size_t place) {
        const std::int64_t c = value[j];
        if (c == 0) return;
        if (c > limit || c < -limit) {
            is_small = false;
            return;
        }
        const auto high = static_cast<double>(c);
        const auto low = static_cast<double>(c - static_cast<std::int64_t>(high));
        const DoubleDouble cosine = cosines[place];
        const double product = high * cosine.high;
        const double lost = std::fma(high, cosine.high, -product);
        const auto [next, error] = two_sum(sum.high, product);
        sum.high = next;
        sum.low += error + (lost + (high * cosine.low + low * cosine.high));
        size += std::abs(high);
    });
    if (!is_small) return std::nullopt;
    const auto n = static_cast<double>(degree);
    const double bound = 2 * (4 * n * (n + 3) + 16) * unit_roundoff * unit_roundoff * size;
    const auto [high, low] = two_sum(sum.high, sum.low);
    if (high + (low + bound) != high) return std::nullopt;
    if (high + (low - bound) != high) return std::nullopt;
    return high;
}

double CyclotomicRing::Context::nearest_double(const std::vector<Integer>& value,
                                               CyclotomicDirection direction) const {
    if (const auto exact = rational(value, direction)) return exact->to_double();
    for (long bits = 128;; bits *= 2)  // ends: an irrational number is no midpoint of two doubles
        if (const auto found = enclosure(value, direction, bits).unique_double()) return *found;
}

std::string CyclotomicRing::Context::decimal(const std::vector<Integer>& value,
                                             CyclotomicDirection direction, int digits,
                                             const Rational& factor) const {
    if (const auto exact = rational(value, direction))
        return algae::decimal(*exact * factor, digits);
    if (factor.is_zero()) return algae::decimal(factor, digits);
    // An irrational number is no midpoint of two decimals: some precision is enough.
    const auto enclose = [&](long bits) {
        return enclosure(value, direction, bits) * Ball(factor, bits);
    };
    return algae::decimal(enclose, digits, 1L << 28);
}

}  // namespace algae
