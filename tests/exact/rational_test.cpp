#include "exact/exact.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "exact/any_numbers.hpp"

using namespace algae;

namespace {

/// A double as the rational number it is.
Rational exact(double x) {
    int exponent = 0;
    const double mantissa = std::ldexp(std::frexp(x, &exponent), 53);
    return Rational(static_cast<std::int64_t>(mantissa)) * power(Rational(2), exponent - 53);
}

}  // namespace

TEST_CASE("what people write") {
    CHECK(Rational("257/10") == Rational(257, 10));
    CHECK(Rational("25.7") == Rational(257, 10));
    CHECK(Rational("-0.5") == Rational(-1, 2));
    CHECK(Rational(".5") == Rational(1, 2));
    CHECK(Rational("-.25") == Rational(-1, 4));
    CHECK(Rational("1e-3") == Rational(1, 1000));
    CHECK(Rational("1.5E+3") == 1500);
    CHECK(Rational("7") == 7);
    CHECK(Rational("+6/4") == Rational(3, 2));
    CHECK(Rational("-0") == 0);
    for (const char* text :
         {"",    "-",    ".",   "1.",  "1/",  "/2",    "1/-2", "1.5/2", "e3",  "1e",
          "1e+", "1 /2", "1,5", "0x1", "--1", "1e3.0", "1..2", "nan",   "inf", ".e1"}) {
        CAPTURE(text);
        CHECK_THROWS_WITH_AS(Rational{text},
                             ("expected a number such as 7, 257/10, 25.7 or 1e-3, found \"" +
                              std::string(text) + "\"")
                                 .c_str(),
                             Error);
    }
    CHECK_THROWS_WITH_AS(Rational("1e10001"), "expected an exponent of at most 10000, found 10001",
                         Error);
    CHECK_THROWS_AS(Rational("1e99999999999999999999"), Error);
    CHECK_THROWS_AS(Rational("1e-99999999999999999999"), Error);
    CHECK(Rational("1e10000") == power(Rational(10), 10000));
    CHECK_THROWS_WITH_AS(Rational("1/0"), "expected a denominator other than 0, found 0", Error);
    CHECK_THROWS_AS(Rational(1, 0), Error);
}

TEST_CASE("the rationals are an ordered field in lowest terms") {
    CHECK(rc::check("field", [](const Rational& a, const Rational& b, const Rational& c) {
        RC_ASSERT((a + b) + c == a + (b + c));
        RC_ASSERT((a * b) * c == a * (b * c));
        RC_ASSERT(a * (b + c) == a * b + a * c);
        RC_ASSERT(a - b == a + -b);
        RC_ASSERT((a <=> b) == (sign(a - b) <=> 0));
        for (const Rational& x : {a + b, a * b, a - c}) {
            RC_ASSERT(gcd(x.numerator(), x.denominator()) == 1);
            RC_ASSERT(x.denominator() > 0);
        }
        if (!b.is_zero()) RC_ASSERT(a / b * b == a);
    }));
    CHECK(rc::check("cross multiplication", [](const Rational& a, const Rational& b) {
        const Rational sum = a + b;
        RC_ASSERT(sum.numerator() * a.denominator() * b.denominator() ==
                  sum.denominator() *
                      (a.numerator() * b.denominator() + b.numerator() * a.denominator()));
        RC_ASSERT((a < b) == (a.numerator() * b.denominator() < b.numerator() * a.denominator()));
    }));
    CHECK(rc::check("with itself", [](const Rational& a) {
        Rational x = a;
        x += x;
        RC_ASSERT(x == 2 * a);
        x *= x;
        RC_ASSERT(x == 4 * a * a);
        x -= x;
        RC_ASSERT(x.is_zero());
        if (!a.is_zero()) {
            x = a;
            x /= x;
            RC_ASSERT(x == 1);
        }
    }));
    CHECK(rc::check("powers", [](const Rational& a) {
        RC_PRE(!a.is_zero());
        const int n = *rc::gen::inRange(-8, 9);
        RC_ASSERT(power(a, n) * power(a, -n) == 1);
        RC_ASSERT(power(a, n + 1) == power(a, n) * a);
    }));
    CHECK_THROWS_AS(Rational(1) / Rational(0), Error);
    CHECK_THROWS_AS(power(Rational(0), -1), Error);
    CHECK_THROWS_AS(power(Rational(2), std::numeric_limits<long>::min()), BoundReached);
}

TEST_CASE("rounding to integers") {
    CHECK(rc::check([](const Rational& a) {
        RC_ASSERT(floor(a) <= a);
        RC_ASSERT(a < floor(a) + 1);
        RC_ASSERT(ceiling(a) - floor(a) == (a.is_integer() ? 0 : 1));
        RC_ASSERT(abs(round_half_even(a) - a) <= Rational(1, 2));
    }));
    CHECK(round_half_even(Rational(1, 2)) == 0);
    CHECK(round_half_even(Rational(3, 2)) == 2);
    CHECK(round_half_even(Rational(-1, 2)) == 0);
    CHECK(round_half_even(Rational(-5, 2)) == -2);
}

TEST_CASE("text") {
    CHECK(
        rc::check("round trip", [](const Rational& a) { RC_ASSERT(Rational(to_string(a)) == a); }));
    CHECK(to_string(Rational(10, 2)) == "5");
    CHECK(to_string(Rational(-257, 10)) == "-257/10");
}

TEST_CASE("decimals") {
    CHECK(rc::check("is within half a unit of the last digit", [](const Rational& a) {
        const int digits = *rc::gen::inRange(0, 40);
        const std::string text = decimal(a, digits);
        const Rational shown(text);
        RC_ASSERT(abs(shown - a) * power(Rational(10), digits) <= Rational(1, 2));
        RC_ASSERT(text.size() - (digits > 0 ? text.find('.') + 1 : text.size()) ==
                  static_cast<std::size_t>(digits));
    }));
    CHECK(decimal(Rational(1, 8), 2) == "0.12");
    CHECK(decimal(Rational(3, 8), 2) == "0.38");
    CHECK(decimal(Rational(-1, 1000), 2) == "0.00");
    CHECK(decimal(Rational(999, 1000), 2) == "1.00");
    CHECK(decimal(Rational(5, 2), 0) == "2");
    CHECK(decimal(81, 3) == "81.000");
    CHECK_THROWS_AS(decimal(1, -1), Error);
    CHECK_THROWS_AS(decimal(1, std::numeric_limits<int>::max()), Error);

    CHECK(rc::check("an exact decimal is exact and as short as can be", [](const Rational& a) {
        const auto text = exact_decimal(a);
        Integer rest = a.denominator();
        for (const int p : {2, 5})
            while (remainder(rest, p) == 0) rest = exact_divide(rest, p);
        RC_ASSERT(text.has_value() == (rest == 1));
        if (!text) return;
        RC_ASSERT(Rational(*text) == a);
        RC_ASSERT((text->find('.') == std::string::npos || text->back() != '0'));
    }));
    CHECK(exact_decimal(Rational(-1, 1024)) == "-0.0009765625");
    CHECK(exact_decimal(Rational(1, 250)) == "0.004");
    CHECK(exact_decimal(7) == "7");
    CHECK(!exact_decimal(Rational(1, 30)));
    CHECK(!exact_decimal(Rational(1, power(Integer(2), 10'000'001))));
}

TEST_CASE("the nearest double") {
    const auto check_nearest = [](const Rational& a) {
        const double x = a.to_double();
        RC_PRE(std::isfinite(x) && std::isfinite(std::nextafter(x, HUGE_VAL)) &&
               std::isfinite(std::nextafter(x, -HUGE_VAL)));
        const Rational error = abs(exact(x) - a);
        RC_ASSERT(error <= abs(exact(std::nextafter(x, HUGE_VAL)) - a));
        RC_ASSERT(error <= abs(exact(std::nextafter(x, -HUGE_VAL)) - a));
    };
    CHECK(rc::check("of any size", check_nearest));
    CHECK(rc::check("among the smallest", [&](const Rational& a) {
        RC_PRE(!a.is_zero());
        const auto bits = static_cast<long>(bit_length(a.numerator())) -
                          static_cast<long>(bit_length(a.denominator()));
        check_nearest(a * power(Rational(2), -1022 - bits - *rc::gen::inRange(-3, 60)));
    }));
    CHECK(rc::check("doubles come back", [](std::int64_t mantissa, int exponent) {
        const double x = std::ldexp(static_cast<double>(mantissa), exponent % 900);
        RC_ASSERT(exact(x).to_double() == x);
    }));
    CHECK(Rational(1, 3).to_double() == 1.0 / 3);
    const Rational smallest = power(Rational(2), -1074);
    CHECK((smallest / 2).to_double() == 0);
    CHECK((smallest * Rational(1000001, 2000000)).to_double() == 0x1p-1074);
    CHECK((smallest * Rational(3, 2)).to_double() == 0x1p-1073);
    CHECK(power(Rational(10), 400).to_double() == HUGE_VAL);
    CHECK(power(Rational(10), -400).to_double() == 0);
}

TEST_CASE("a double is the rational that its bits say") {
    CHECK(rc::check([](std::int64_t mantissa, int exponent) {
        const double x = std::ldexp(static_cast<double>(mantissa), exponent % 900);
        RC_ASSERT(exactly(x) == exact(x));
    }));
    CHECK(exactly(0.1) != Rational("0.1"));
    CHECK(exactly(-0.0) == 0);
    CHECK(exactly(0x1p-1074) == power(Rational(2), -1074));
    CHECK_THROWS_AS(exactly(HUGE_VAL), Error);
}

TEST_CASE("equal numbers have equal hashes") {
    CHECK(rc::check([](const Rational& a, const Rational& b) {
        RC_ASSERT(hash_value(a + b - b) == hash_value(a));
    }));
}
