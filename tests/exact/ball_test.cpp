#include "exact/exact.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "exact/any_numbers.hpp"

using namespace algae;

TEST_CASE("operations enclose what exact arithmetic gives") {
    CHECK(rc::check([](const Rational& a, const Rational& b) {
        const long bits = *rc::gen::inRange(2L, 200L);
        const Ball x(a, bits), y(b, bits);
        RC_ASSERT(x.contains(a));
        RC_ASSERT((x + y).contains(a + b));
        RC_ASSERT((x - y).contains(a - b));
        RC_ASSERT((x * y).contains(a * b));
        RC_ASSERT((-x).contains(-a));
        RC_ASSERT(abs(x).contains(abs(a)));
        if (!b.is_zero()) RC_ASSERT((x / y).contains(a / b));
        RC_ASSERT(sqrt(Ball(a * a, bits)).contains(abs(a)));
        RC_ASSERT(x.lower() <= a);
        RC_ASSERT(a <= x.upper());
        RC_ASSERT(hull(x, y).contains(x));
        RC_ASSERT(hull(x, y).contains((a + b) / 2));
        switch (compare(x, y)) {
            case Order::less:
                RC_ASSERT(a < b);
                break;
            case Order::greater:
                RC_ASSERT(a > b);
                break;
            case Order::equal:
                RC_ASSERT(a == b);
                break;
            case Order::unknown:
                RC_ASSERT(x.overlaps(y));
                break;
        }
        if (const auto s = sign(x)) RC_ASSERT(*s == sign(a));
    }));
}

TEST_CASE("functions enclose each other's inverses and known values") {
    CHECK(rc::check([] {
        const Rational a(*rc::gen::inRange(1, 2000), *rc::gen::inRange(1, 2000));
        const long bits = *rc::gen::inRange(2L, 300L);
        RC_ASSERT(exp(log(Ball(a, bits))).contains(a));
        RC_ASSERT(power(sqrt(Ball(a, bits)), Ball(2, bits)).contains(a));
        const Ball c = cos_pi(a, bits), s = sin_pi(a, bits);
        RC_ASSERT((c * c + s * s).contains(Rational(1)));
        RC_ASSERT((cos_pi(2 * a, bits) - (c * c - s * s)).contains(Rational(0)));
    }));
    CHECK(cos_pi(Rational(1, 3), 64).contains(Rational(1, 2)));
    CHECK(sin_pi(Rational(1, 6), 64).contains(Rational(1, 2)));
    CHECK(pi(200).has_radius_below(-190));
    CHECK(pi(64).midpoint() == std::acos(-1.0));
    CHECK(exp(log(Ball(3, 128)) * Ball(2, 128)).unique_integer() == 9);
    CHECK(!Ball(Rational(1, 3), 64).unique_integer());
    CHECK(Ball(Rational(1, 3), 200).unique_double() == 1.0 / 3);
    CHECK(!Ball(Rational(1, 3), 10).unique_double());
}

TEST_CASE("where there is no real result, the enclosure is everything") {
    CHECK(!(Ball(1, 64) / Ball(0, 64)).is_finite());
    CHECK(!sqrt(Ball(-1, 64)).is_finite());
    CHECK(!log(Ball(0, 64)).is_finite());
    CHECK(!log(Ball(-1, 64)).is_finite());
    const Ball everything = log(Ball(-1, 64));
    CHECK(compare(everything, Ball(0, 64)) == Order::unknown);
    CHECK(!sign(everything));
    CHECK(!everything.unique_integer());
    CHECK(!everything.unique_double());
    CHECK_THROWS_AS(everything.lower(), Error);
    CHECK_THROWS_AS(decimal([](long bits) { return log(Ball(-1, bits)); }, 3), BoundReached);
}

TEST_CASE("enormous and minute numbers are handled, not written out") {
    const Ball large = exp(Ball(power(Integer(10), 15), 64));
    const Ball small = Ball(1, 64) / exp(Ball(power(Integer(10), 15), 64));
    for (const Ball& x : {large, small, -large, large + small, large * Ball(Rational(1, 3), 64)}) {
        CHECK(!x.unique_integer());
        (void)to_string(x);
        (void)x.midpoint();
        (void)x.contains(Rational(1, 3));
        (void)x.contains(Rational(0));
        (void)compare(x, Ball(1, 64));
        (void)compare(x, small);
        (void)cos_pi(Rational(1, 7), 64).overlaps(x);
        (void)x.unique_double();
        (void)hull(x, small);
        (void)sqrt(x);
        (void)exp(x);
        (void)log(x);
        CHECK_THROWS_AS(x.lower(), BoundReached);
        CHECK_THROWS_AS(significant_decimal([&](long) { return x; }, 5), BoundReached);
    }
    CHECK_THROWS_AS(decimal([&](long) { return large; }, 5), BoundReached);
    CHECK(decimal([&](long) { return small; }, 5) == "0.00000");
    CHECK(!power(large, large).is_finite());
    CHECK_THROWS_AS(Ball(1, 1), Error);
    CHECK_THROWS_AS(Ball(1, std::numeric_limits<long>::max()), Error);
}

TEST_CASE("decimals of numbers known by enclosures are correctly rounded") {
    CHECK(rc::check("as those of rationals", [](const Rational& a) {
        const int digits = *rc::gen::inRange(0, 30);
        const Rational tie = abs(a) * power(Rational(10), digits) - Rational(1, 2);
        RC_PRE(!tie.is_integer());
        RC_ASSERT(decimal([&](long bits) { return Ball(a, bits); }, digits) == decimal(a, digits));
    }));
    CHECK(rc::check("significant digits", [](const Rational& a) {
        RC_PRE(!a.is_zero());
        const int digits = *rc::gen::inRange(1, 30);
        std::string text;
        try {
            text = significant_decimal([&](long bits) { return Ball(a, bits); }, digits);
        } catch (const BoundReached&) {
            RC_DISCARD("a tie");
        }
        // The value of one unit in the last digit, from the exact number alone.
        Rational unit = 1;
        while (abs(a) >= unit * 10) unit *= 10;
        while (abs(a) < unit) unit /= 10;
        unit *= power(Rational(10), 1 - digits);
        RC_ASSERT(abs(Rational(text) - a) * 2 <= unit);
        RC_ASSERT((Rational(text) / unit).is_integer());
        std::string shown;
        for (const char c : text)
            if (c >= '0' && c <= '9' && !(shown.empty() && c == '0')) shown += c;
        // 9.52 with one digit is 10, which has two; 0.952 with one digit is 1.
        const bool longer = unit == 1 && abs(Rational(text)) == power(Rational(10), digits);
        if (unit <= 1) RC_ASSERT(shown.size() == static_cast<std::size_t>(digits) + longer);
    }));
    const auto root = [](long bits) { return sqrt(Ball(2, bits)); };
    CHECK(decimal(root, 5) == "1.41421");
    CHECK(decimal(root, 0) == "1");
    CHECK(significant_decimal(root, 5) == "1.4142");
    CHECK(decimal(root, 60) == "1.414213562373095048801688724209698078569671875376948073176680");
    CHECK(decimal(root, 30'000).substr(0, 12) == "1.4142135623");
    const auto koch = [](long bits) { return log(Ball(4, bits)) / log(Ball(3, bits)); };
    CHECK(decimal(koch, 10) == "1.2618595071");
    const auto two = [](long bits) { return log(Ball(4, bits)) / log(Ball(2, bits)); };
    CHECK(decimal(two, 6) == "2.000000");
    CHECK(significant_decimal(two, 3) == "2.00");
    CHECK(significant_decimal([](long bits) { return Ball(Rational("9.996"), bits); }, 3) ==
          "10.0");
    CHECK(significant_decimal([](long bits) { return Ball(Rational("-0.0009996"), bits); }, 3) ==
          "-0.00100");
    CHECK(significant_decimal([](long bits) { return Ball(123456, bits); }, 3) == "123000");
    CHECK(significant_decimal([](long bits) { return exp(Ball(-5, bits)); }, 3) == "0.00674");
    CHECK(significant_decimal([](long bits) { return Ball(Rational("12.25"), bits); }, 2) == "12");
    CHECK(significant_decimal([](long bits) { return Ball(1000, bits); }, 2) == "1000");
    CHECK(significant_decimal([](long bits) { return Ball(1, bits); }, 3) == "1.00");
    CHECK(significant_decimal([](long bits) { return Ball(Rational("0.952"), bits); }, 1) == "1");
    CHECK(significant_decimal([](long bits) { return Ball(Rational("9.52"), bits); }, 1) == "10");
    const auto half = [](long bits) { return exp(log(Ball(Rational(1, 2), bits))); };
    CHECK_THROWS_AS(decimal(half, 0), BoundReached);  // a tie cannot be proved by enclosures
    CHECK_THROWS_AS(decimal(half, -1), Error);
}
