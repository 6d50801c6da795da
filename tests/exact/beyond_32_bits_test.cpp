// Numbers at the limits of machine words of 32 and 64 bits: what fails where one is silently narrowed.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_set>
#include <vector>

#include "exact/exact.hpp"

using namespace algae;

namespace {

/// 2^k - 1, 2^k and 2^k + 1 with both signs, for the k at which words of some kind end.
std::vector<std::int64_t> signed_limits() {
    std::vector<std::int64_t> limits{0, std::numeric_limits<std::int64_t>::min(),
                                     std::numeric_limits<std::int64_t>::min() + 1,
                                     std::numeric_limits<std::int64_t>::max()};
    for (const int k : {15, 16, 29, 30, 31, 32, 33, 61, 62})
        for (const std::int64_t by : {-1, 0, 1}) {
            limits.push_back((std::int64_t{1} << k) + by);
            limits.push_back(-(std::int64_t{1} << k) + by);
        }
    return limits;
}

}  // namespace

TEST_CASE("numbers of 64 bits come and go whole") {
    for (const std::int64_t x : signed_limits()) {
        CAPTURE(x);
        CHECK(to_string(Integer(x)) == std::to_string(x));
        CHECK(Integer(std::to_string(x)) == Integer(x));
        CHECK(Integer(x).to_int64() == x);
        CHECK(Integer(std::to_string(x)).to_int64() == x);
        CHECK(Integer(x).fits_uint64() == (x >= 0));
        const auto bits = static_cast<std::uint64_t>(x);
        CHECK(to_string(Integer(bits)) == std::to_string(bits));
        CHECK(Integer(std::to_string(bits)).to_uint64() == bits);
        CHECK(Integer(bits).fits_int64() == (bits <= INT64_MAX));
        CHECK(Integer(x).to_double() == static_cast<double>(x));
        CHECK(Integer(bits).to_double() == static_cast<double>(bits));
        CHECK(Rational(x, 2).numerator() * 2 == Integer(x) * Rational(x, 2).denominator());
    }
    CHECK_FALSE((Integer(INT64_MAX) + 1).fits_int64());
    CHECK_FALSE((Integer(INT64_MIN) - 1).fits_int64());
    CHECK_FALSE((Integer(UINT64_MAX) + 1).fits_uint64());
    CHECK((Integer(INT64_MIN) + 1 - 1).to_int64() == INT64_MIN);
    CHECK((Integer(UINT64_MAX) + 1 - 1).to_uint64() == UINT64_MAX);
}

TEST_CASE("sums and products carry beyond 32 bits") {
    for (const std::int64_t x : signed_limits())
        for (const std::int64_t y : signed_limits()) {
            std::int64_t expected = 0;
            if (!__builtin_add_overflow(x, y, &expected)) {
                CHECK((Integer(x) + y).to_int64() == expected);
                CHECK(Integer(x) + y == Integer(expected));
            }
            if (!__builtin_sub_overflow(x, y, &expected))
                CHECK((Integer(x) - y).to_int64() == expected);
            if (!__builtin_mul_overflow(x, y, &expected))
                CHECK((Integer(x) * y).to_int64() == expected);
            CHECK((Integer(x) <=> Integer(y)) == (x <=> y));
            CHECK((Integer(x) == Integer(y)) == (x == y));
        }
}

TEST_CASE("powers of two beyond 32 bits are as long as they should be") {
    for (const std::uint64_t k : {31u, 32u, 33u, 63u, 64u, 65u, 95u, 96u, 1023u}) {
        const Integer two = power(Integer(2), k);
        CHECK(bit_length(two) == k + 1);
        CHECK(bit_length(two - 1) == k);
        CHECK(two.to_double() == std::ldexp(1.0, static_cast<int>(k)));
        CHECK(floor_divide(two, power(Integer(2), k - 1)) == 2);
    }
}

TEST_CASE("exponents have 64 bits where the power is short") {
    for (const std::uint64_t n :
         {std::uint64_t{1} << 32, (std::uint64_t{1} << 32) + 1, UINT64_MAX - 1, UINT64_MAX}) {
        CHECK(power(Integer(0), n) == 0);
        CHECK(power(Integer(1), n) == 1);
        CHECK(power(Integer(-1), n) == (n % 2 == 0 ? 1 : -1));
    }
    CHECK_THROWS_AS(power(Integer(2), UINT64_MAX), BoundReached);
    CHECK_THROWS_AS(power(Integer(2), Integer::largest_bit_length), BoundReached);
    CHECK(power(Integer(0), 0) == 1);
    CHECK(power(Rational(-1), std::int64_t{1} << 32) == 1);
    CHECK(power(Rational(-1), -(std::int64_t{1} << 32) - 1) == -1);
    CHECK_THROWS_AS(power(Rational(1, 2), std::int64_t{1} << 34), BoundReached);
}

TEST_CASE("equal numbers have equal hashes, whether they are one word or more") {
    std::unordered_set<Integer> seen;
    for (const std::int64_t x : signed_limits()) {
        CHECK(hash_value(Integer(x)) == hash_value(Integer(std::to_string(x))));
        seen.insert(Integer(x));
    }
    for (const std::int64_t x : signed_limits()) CHECK(seen.contains(Integer(std::to_string(x))));
    CHECK(hash_value(Integer(1)) != hash_value(Integer((std::int64_t{1} << 32) + 1)));
}

TEST_CASE("exponents of zeta beyond 32 bits are reduced") {
    const CyclotomicRing ring(12);
    for (const std::int64_t k : signed_limits()) {
        const std::int64_t rest = (k % 12 + 12) % 12;
        CHECK(ring.zeta(k) == ring.zeta(rest));
        CHECK(ring.rotate(ring.one(), k) == ring.zeta(rest));
        CHECK(ring.compare_along(ring.one(), ring.zeta(5), k) ==
              ring.compare_along(ring.one(), ring.zeta(5), rest));
    }
}

TEST_CASE("polynomials, matrices and enclosures hold numbers beyond 32 bits") {
    const Integer large(std::int64_t{1} << 40);
    CHECK((Polynomial({large, 1}) * Polynomial({-large, 1})).coefficient(0) == -large * large);
    CHECK(characteristic_polynomial(IntegerMatrix{{large, 1}, {0, -large}}) ==
          Polynomial({-large * large, 0, 1}));
    CHECK(determinant(IntegerMatrix{{large, 0}, {0, large}}) == power(Integer(2), 80));
    CHECK(power(IntegerMatrix{{1, 1}, {0, 1}}, large, 128)(0, 1) == large);
    CHECK(Ball(large, 64).unique_integer() == large);
    CHECK(Ball(Rational(1, large), 64).lower() == Rational(1, large));
    CHECK(exact_decimal(Rational(large, 5)) == "219902325555.2");
    const auto tiny = [&](long bits) { return Ball(Rational(1, large * large * large), bits); };
    CHECK(significant_decimal(tiny, 3) == "0.000000000000000000000000000000000000752");
}
