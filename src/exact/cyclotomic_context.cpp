#include "exact/cyclotomic_context.hpp"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <numeric>

#include "exact/arb.hpp"
#include "exact/polynomial.hpp"

namespace algae {

namespace {

/// The product of the primes that divide the order.
long radical(long order) {
    long result = 1;
    for (long p = 2; p <= order; ++p)
        if (order % p == 0) {
            result *= p;
            while (order % p == 0) order /= p;
        }
    return result;
}

}  // namespace

CyclotomicRing::Context::Context(long m)
    : order(static_cast<std::size_t>(m)),
      turn(std::lcm(std::size_t{4}, order)),
      step(turn / order) {
    const long r = radical(m);
    stride = static_cast<std::uint32_t>(m / r);
    const Polynomial phi = cyclotomic_polynomial(r);
    const auto small_degree = static_cast<std::size_t>(phi.degree());
    degree = small_degree * stride;

    std::vector<std::int64_t> modulus;
    for (std::size_t i = 0; i < small_degree; ++i) modulus.push_back(phi.coefficient(i).to_int64());
    std::vector<std::int64_t> power(small_degree);
    power[0] = 1;
    starts.push_back(0);
    for (long q = 0; q < r; ++q) {
        for (std::size_t i = 0; i < small_degree; ++i) {
            if (power[i] == 0) continue;
            assert(std::abs(power[i]) <= INT16_MAX);  // 18 is the largest up to order 3600, at 3135
            terms.push_back({static_cast<std::uint16_t>(i), static_cast<std::int16_t>(power[i])});
        }
        starts.push_back(terms.size());
        // Times zeta: shift, and replace what leaves at the top by lower powers.
        const std::int64_t top = power.back();
        for (std::size_t i = small_degree; i-- > 1;) power[i] = power[i - 1] - top * modulus[i];
        power[0] = -top * modulus[0];
    }

    cosines.reserve(turn);
    for (std::size_t j = 0; j < turn; ++j) {
        Ball value = cos_pi(Rational(2 * j, turn), 192);
        const double high = value.midpoint();
        Ball exact_high = ball(192);
        arb_set_d(arb(exact_high), high);
        cosines.push_back({high, (value - exact_high).midpoint()});
    }
}

const std::vector<std::int64_t>& CyclotomicRing::Context::dense_powers() const {
    std::call_once(dense_once, [this] {
        dense.assign(order * degree, 0);
        for (std::size_t k = 0; k < order; ++k)
            for_terms(k, [&](std::size_t index, int coefficient) {
                dense[k * degree + index] = coefficient;
            });
    });
    return dense;
}

std::vector<Integer> CyclotomicRing::Context::doubled(const std::vector<Integer>& value,
                                                      CyclotomicDirection direction) const {
    std::vector<Integer> sum(degree);
    if (direction.offset % step == 0) {  // Re(zeta^k x) = (zeta^k x + its conjugate) / 2
        const std::size_t k = direction.offset / step;
        for (std::size_t j = 0; j < degree; ++j) {
            if (value[j].is_zero()) continue;
            const std::size_t exponent = add_exponents(j, k);
            add_power(sum, exponent, value[j]);
            add_power(sum, opposite(exponent), value[j]);
        }
    } else {  // i Im(x) = (x - its conjugate) / 2
        for (std::size_t j = 0; j < degree; ++j) {
            if (value[j].is_zero()) continue;
            add_power(sum, j, value[j]);
            add_power(sum, opposite(j), -value[j]);
        }
    }
    return sum;
}

std::optional<Rational> CyclotomicRing::Context::rational(const std::vector<Integer>& value,
                                                          CyclotomicDirection direction) const {
    const std::vector<Integer> twice = doubled(value, direction);
    const auto is_zero = [](const Integer& x) { return x.is_zero(); };
    if (!std::all_of(twice.begin() + 1, twice.end(), is_zero)) return std::nullopt;
    // Where i is not in the ring, i times a rational is in it only for 0, whose coordinates are 0.
    return Rational(twice.front(), 2);
}

}  // namespace algae
