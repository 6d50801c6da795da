#include "exact/exact.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_set>

#include "exact/any_numbers.hpp"

using namespace algae;

namespace {

const std::vector<long> orders = {1,  2,  3,  4,  5,  6,  7,  8,  9,   10,  12,  15, 16,
                                  18, 20, 24, 30, 36, 45, 60, 72, 105, 180, 210, 360};

CyclotomicRing any_ring() { return CyclotomicRing(*rc::gen::elementOf(orders)); }

CyclotomicInteger any_small(const CyclotomicRing& ring) {
    CyclotomicInteger value = ring.zero();
    for (Integer& c : value.coefficients) c = *rc::gen::inRange(-100, 101);
    return value;
}

CyclotomicInteger any_element(const CyclotomicRing& ring) {
    CyclotomicInteger value = ring.zero();
    for (Integer& c : value.coefficients) c = *rc::gen::arbitrary<Integer>();
    return value;
}

/// The number in floating point, from the definition.
std::complex<double> approximately(const CyclotomicRing& ring, const CyclotomicInteger& value) {
    std::complex<double> sum;
    for (std::size_t j = 0; j < value.coefficients.size(); ++j)
        sum += value.coefficients[j].to_double() *
               std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(j) /
                                   static_cast<double>(ring.order()));
    return sum;
}

/// An enclosure of a part from the definition, to many bits, without the ring's tables.
Ball part(const CyclotomicRing& ring, const CyclotomicInteger& value, bool imaginary, long bits) {
    Ball sum(0, bits);
    for (std::size_t j = 0; j < value.coefficients.size(); ++j) {
        const Rational angle(2 * j, ring.order());
        sum += Ball(value.coefficients[j], bits) *
               (imaginary ? sin_pi(angle, bits) : cos_pi(angle, bits));
    }
    return sum;
}

CyclotomicInteger sum(const CyclotomicRing& ring, CyclotomicInteger left,
                      const CyclotomicInteger& right) {
    ring.add(left, right);
    return left;
}

CyclotomicInteger difference(const CyclotomicRing& ring, CyclotomicInteger left,
                             const CyclotomicInteger& right) {
    ring.subtract(left, right);
    return left;
}

}  // namespace

TEST_CASE("the reduced powers are x^k modulo the cyclotomic polynomial") {
    for (const long m :
         {1L, 2L, 3L, 4L, 5L, 6L, 8L, 9L, 12L, 30L, 45L, 72L, 105L, 180L, 210L, 385L, 720L}) {
        const CyclotomicRing ring(m);
        const Polynomial modulus = cyclotomic_polynomial(m);
        REQUIRE(static_cast<long>(ring.degree()) == modulus.degree());
        for (long k = 0; k < m; ++k) {
            const Polynomial reduced =
                remainder(Polynomial::monomial(1, static_cast<std::size_t>(k)), modulus);
            REQUIRE(Polynomial(ring.zeta(k).coefficients) == reduced);
            const auto machine = ring.power(k - 5 * m);
            REQUIRE(Polynomial(std::vector<Integer>(machine.begin(), machine.end())) == reduced);
        }
        CHECK(ring.zeta(std::numeric_limits<long>::min()) ==
              ring.zeta(remainder(Integer(std::numeric_limits<long>::min()), m).to_int64()));
    }
}

TEST_CASE("products agree with polynomials modulo the cyclotomic polynomial") {
    CHECK(rc::check([] {
        const CyclotomicRing ring = any_ring();
        const CyclotomicInteger x = any_element(ring), y = any_element(ring);
        const Polynomial expected =
            remainder(Polynomial(x.coefficients) * Polynomial(y.coefficients),
                      cyclotomic_polynomial(ring.order()));
        RC_ASSERT(Polynomial(ring.multiply(x, y).coefficients) == expected);
    }));
}

TEST_CASE("the ring, its rotations and its conjugation obey their laws") {
    CHECK(rc::check([](int j, int k) {
        const CyclotomicRing ring = any_ring();
        const CyclotomicInteger x = any_element(ring), y = any_element(ring), z = any_small(ring);
        RC_ASSERT(ring.multiply(x, sum(ring, y, z)) ==
                  sum(ring, ring.multiply(x, y), ring.multiply(x, z)));
        RC_ASSERT(ring.multiply(x, y) == ring.multiply(y, x));
        RC_ASSERT(ring.multiply(ring.multiply(x, y), z) == ring.multiply(x, ring.multiply(y, z)));
        RC_ASSERT(ring.multiply(x, ring.one()) == x);
        RC_ASSERT(ring.rotate(x, k) == ring.multiply(x, ring.zeta(k)));
        RC_ASSERT(ring.rotate(ring.rotate(x, j), k) == ring.rotate(x, static_cast<long>(j) + k));
        RC_ASSERT(ring.rotate(x, ring.order()) == x);
        CyclotomicInteger accumulated = x;
        ring.add_rotated(accumulated, y, k);
        RC_ASSERT(accumulated == sum(ring, x, ring.rotate(y, k)));
        accumulated = x;
        ring.add_rotated(accumulated, accumulated, k);
        RC_ASSERT(accumulated == sum(ring, x, ring.rotate(x, k)));
        RC_ASSERT(ring.conjugate(ring.conjugate(x)) == x);
        RC_ASSERT(ring.conjugate(ring.multiply(x, z)) ==
                  ring.multiply(ring.conjugate(x), ring.conjugate(z)));
        RC_ASSERT(ring.conjugate(ring.zeta(k)) == ring.zeta(-static_cast<long>(k)));
        RC_ASSERT(difference(ring, x, x) == ring.zero());
        CyclotomicInteger doubled = x;
        ring.scale(doubled, -2);
        ring.negate(doubled);
        RC_ASSERT(doubled == sum(ring, x, x));
        RC_ASSERT(std::hash<CyclotomicInteger>()(doubled) == hash_value(sum(ring, x, x)));
    }));
}

TEST_CASE("numbers are where complex doubles say") {
    CHECK(rc::check([](int k) {
        const CyclotomicRing ring = any_ring();
        const CyclotomicInteger x = any_small(ring), y = any_small(ring);
        const auto close = [](std::complex<double> a, std::complex<double> b) {
            return std::abs(a - b) < 1e-4;
        };
        RC_ASSERT(close(ring.to_complex(x), approximately(ring, x)));
        RC_ASSERT(close(ring.to_complex(ring.multiply(x, y)),
                        approximately(ring, x) * approximately(ring, y)));
        RC_ASSERT(close(ring.to_complex(ring.conjugate(x)), std::conj(approximately(ring, x))));
        const double turn = 2 * std::numbers::pi * static_cast<double>(k % ring.order()) /
                            static_cast<double>(ring.order());
        RC_ASSERT(close(ring.to_complex(ring.rotate(x, k)),
                        approximately(ring, x) * std::polar(1.0, turn)));
    }));
}

TEST_CASE("the parts as doubles are the nearest ones") {
    CHECK(rc::check([] {
        const CyclotomicRing ring = any_ring();
        const CyclotomicInteger x =
            *rc::gen::arbitrary<bool>() ? any_small(ring) : any_element(ring);
        const std::complex<double> found = ring.to_complex(x);
        for (const bool imaginary : {false, true}) {
            const double value = imaginary ? found.imag() : found.real();
            const auto rational = imaginary ? ring.imaginary_rational(x) : ring.real_rational(x);
            const Ball enclosure = part(ring, x, imaginary, 20'000);
            if (rational) {
                RC_ASSERT(enclosure.contains(*rational));
                RC_ASSERT(value == rational->to_double());
            } else {
                RC_ASSERT(enclosure.unique_double() == value);
            }
            RC_ASSERT((imaginary ? ring.imaginary_part(x, 90) : ring.real_part(x, 90))
                          .overlaps(enclosure));
        }
    }));
}

TEST_CASE("signs and comparisons agree with many digits") {
    CHECK(rc::check([](int k) {
        const CyclotomicRing ring = any_ring();
        const CyclotomicInteger x = any_element(ring);
        // Three kinds of y: any, with the same real part, and extremely near.
        CyclotomicInteger y = any_element(ring);
        const int kind = *rc::gen::inRange(0, 3);
        if (kind == 1) y = ring.conjugate(x);
        if (kind == 2) {
            y = x;
            y.coefficients.back() += *rc::gen::inRange(-1, 2);
        }
        const auto expected = [&](const CyclotomicInteger& value, bool imaginary) {
            const Ball enclosure = part(ring, value, imaginary, 20'000);
            return enclosure.contains(Rational(0)) ? 0 : *sign(enclosure);
        };
        const CyclotomicInteger d = difference(ring, x, y);
        RC_ASSERT(ring.real_part_sign(d) == expected(d, false));
        RC_ASSERT(ring.imaginary_part_sign(d) == expected(d, true));
        RC_ASSERT((ring.compare_real(x, y) == (expected(d, false) <=> 0)));
        RC_ASSERT((ring.compare_imaginary(x, y) == (expected(d, true) <=> 0)));
        const long back = -static_cast<long>(k);
        RC_ASSERT((ring.compare_along(x, y, k) ==
                   ring.compare_real(ring.rotate(x, back), ring.rotate(y, back))));
        if (kind == 1) RC_ASSERT((ring.compare_real(x, y) == 0));
    }));
}

TEST_CASE("signs are exact where doubles cannot see them") {
    // In Z[zeta_5], 1 - 2 cos 72 = 0.38...; its powers are minute sums of huge numbers.
    const CyclotomicRing ring(5);
    CyclotomicInteger base = ring.one();
    ring.subtract(base, ring.zeta(1));
    ring.subtract(base, ring.zeta(-1));
    CyclotomicInteger minute = ring.one();
    for (int n = 1; n <= 400; ++n) {
        minute = ring.multiply(minute, base);
        REQUIRE(ring.real_part_sign(minute) == 1);
        REQUIRE(ring.imaginary_part_sign(minute) == 0);
        CyclotomicInteger more = ring.zeta(2);
        ring.add(more, minute);
        REQUIRE((ring.compare_real(more, ring.zeta(2)) > 0));
        REQUIRE((ring.compare_imaginary(more, ring.zeta(2)) == 0));
    }
    CHECK(ring.to_complex(minute).real() ==
          doctest::Approx(std::pow(0.3819660112501051, 400)).epsilon(1e-10));
    CHECK(ring.to_complex(minute).imag() == 0);
}

TEST_CASE("rational parts and decimals") {
    const CyclotomicRing ring(12);
    CyclotomicInteger value = ring.zeta(1);
    ring.scale(value, 81);
    CHECK(!ring.real_rational(value));
    CHECK(ring.imaginary_rational(value) == Rational(81, 2));
    CHECK(ring.real_decimal(value, 3) == "70.148");
    CHECK(ring.imaginary_decimal(value, 3) == "40.500");
    CHECK(ring.imaginary_decimal(value, 0) == "40");
    CHECK(ring.imaginary_decimal(value, 3, Rational(1, 3)) == "13.500");
    CHECK(ring.real_decimal(value, 3, Rational(-1, 81)) == "-0.866");
    CHECK(ring.real_decimal(value, 3, 0) == "0.000");
    CHECK(ring.real_rational(ring.integer(81)) == 81);
    CHECK(ring.imaginary_rational(ring.integer(81)) == 0);
    CHECK(CyclotomicRing(8).real_decimal(CyclotomicRing(8).zeta(1), 40) ==
          "0.7071067811865475244008443621048490392848");
    // i is not in these rings: an imaginary part that is not 0 is irrational.
    for (const long m : {3L, 6L, 7L, 10L, 45L}) {
        CHECK(!CyclotomicRing(m).imaginary_rational(CyclotomicRing(m).zeta(1)));
        CHECK(CyclotomicRing(m).imaginary_rational(CyclotomicRing(m).one()) == 0);
    }
    CHECK(rc::check([] {
        const CyclotomicRing any = any_ring();
        const CyclotomicInteger x = any_element(any);
        const Rational factor = *rc::gen::arbitrary<Rational>();
        const int digits = *rc::gen::inRange(0, 20);
        const std::string text = any.real_decimal(x, digits, factor);
        Ball off =
            part(any, x, false, 20'000) * Ball(factor, 20'000) - Ball(Rational(text), 20'000);
        off *= Ball(2 * power(Rational(10), digits), 20'000);
        RC_ASSERT(compare(abs(off), Ball(Rational(1000001, 1000000), 64)) == Order::less);
    }));
}

TEST_CASE("rings") {
    CHECK(CyclotomicRing(12) == CyclotomicRing(12));
    CHECK(!(CyclotomicRing(12) == CyclotomicRing(6)));
    CHECK(CyclotomicRing(3599).degree() == 3480);  // 59 * 61
    CHECK_THROWS_WITH_AS(CyclotomicRing(0), "expected a cyclotomic order from 1 to 3600, found 0",
                         Error);
    CHECK_THROWS_AS(CyclotomicRing(3601), Error);
    CHECK_THROWS_AS(CyclotomicRing(-4), Error);
    std::unordered_set<CyclotomicInteger> points;
    for (long k = -100; k < 100; ++k) points.insert(CyclotomicRing(30).zeta(k));
    CHECK(points.size() == 30);
}
