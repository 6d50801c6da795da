#include "exact/exact.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <unordered_set>

#include "exact/any_numbers.hpp"

using namespace algae;

namespace {

__extension__ typedef __int128 Wide;  // ISO C++ has no such type: only this test uses it

std::string decimal_of(Wide value) {
    std::string digits;
    const bool negative = value < 0;
    do {
        const int digit = static_cast<int>(value % 10);
        digits += static_cast<char>('0' + (digit < 0 ? -digit : digit));
        value /= 10;
    } while (value != 0);
    if (negative) digits += '-';
    return {digits.rbegin(), digits.rend()};
}

/// Multiplication as at school, on strings of digits.
std::string school_product(const std::string& left, const std::string& right) {
    std::vector<int> digits(left.size() + right.size());
    for (std::size_t i = 0; i < left.size(); ++i)
        for (std::size_t j = 0; j < right.size(); ++j)
            digits[i + j] +=
                (left[left.size() - 1 - i] - '0') * (right[right.size() - 1 - j] - '0');
    std::string result;
    int carry = 0;
    for (const int digit : digits) {
        result += static_cast<char>('0' + (digit + carry) % 10);
        carry = (digit + carry) / 10;
    }
    while (result.size() > 1 && result.back() == '0') result.pop_back();
    return {result.rbegin(), result.rend()};
}

}  // namespace

TEST_CASE("machine numbers of every type keep their value") {
    CHECK(to_string(Integer(std::numeric_limits<std::uint64_t>::max())) == "18446744073709551615");
    CHECK(to_string(Integer(std::numeric_limits<std::int64_t>::min())) == "-9223372036854775808");
    CHECK(to_string(Integer(std::uint8_t{255})) == "255");
    CHECK(to_string(Integer(std::int8_t{-128})) == "-128");
    CHECK(to_string(Integer(true)) == "1");
    CHECK(Integer(-1) < Integer(0u));
    CHECK(rc::check("round trips through 64 bits", [](std::int64_t x, std::uint64_t y) {
        RC_ASSERT(Integer(x).to_int64() == x);
        RC_ASSERT(Integer(y).to_uint64() == y);
        RC_ASSERT(to_string(Integer(x)) == std::to_string(x));
        RC_ASSERT(to_string(Integer(y)) == std::to_string(y));
    }));
}

TEST_CASE("arithmetic agrees with 128-bit numbers") {
    CHECK(rc::check("sum, difference, product, order",
                    [](std::int64_t x, std::int64_t y, unsigned shift) {
                        x >>= shift % 64;  // all sizes, not only the largest
                        const Integer a(x), b(y);
                        RC_ASSERT(to_string(a + b) == decimal_of(Wide(x) + y));
                        RC_ASSERT(to_string(a - b) == decimal_of(Wide(x) - y));
                        RC_ASSERT(to_string(a * b) == decimal_of(Wide(x) * y));
                        RC_ASSERT(to_string(-a) == decimal_of(-Wide(x)));
                        RC_ASSERT((a <=> b) == (x <=> y));
                        RC_ASSERT((a == b) == (x == y));
                        if (y != 0) {
                            Wide quotient = Wide(x) / y, rest = Wide(x) % y;
                            if (rest != 0 && (rest < 0) != (y < 0)) {
                                --quotient;
                                rest += y;
                            }
                            RC_ASSERT(to_string(floor_divide(a, b)) == decimal_of(quotient));
                            RC_ASSERT(to_string(remainder(a, b)) == decimal_of(rest));
                        }
                    }));
}

TEST_CASE("products agree with multiplication as at school") {
    CHECK(rc::check([](const Integer& a, const Integer& b) {
        const std::string size = school_product(to_string(abs(a)), to_string(abs(b)));
        const bool negative = sign(a) * sign(b) < 0;
        RC_ASSERT(to_string(a * b) == (negative ? "-" + size : size));
    }));
}

TEST_CASE("the integers are a ring, ordered, with division") {
    CHECK(rc::check("ring", [](const Integer& a, const Integer& b, const Integer& c) {
        RC_ASSERT((a + b) + c == a + (b + c));
        RC_ASSERT((a * b) * c == a * (b * c));
        RC_ASSERT(a * (b + c) == a * b + a * c);
        RC_ASSERT(a + b == b + a);
        RC_ASSERT(a - b == a + -b);
        RC_ASSERT((a < b) == (a + c < b + c));
        RC_ASSERT((a <=> b) == (sign(a - b) <=> 0));
    }));
    CHECK(rc::check("division", [](const Integer& a, const Integer& b) {
        RC_PRE(!b.is_zero());
        const Integer rest = remainder(a, b);
        RC_ASSERT(a == floor_divide(a, b) * b + rest);
        RC_ASSERT(abs(rest) < abs(b));
        RC_ASSERT(rest == 0 || sign(rest) == sign(b));
        RC_ASSERT(exact_divide(a * b, b) == a);
        if (rest != 0) RC_ASSERT_THROWS_AS(exact_divide(a, b), Error);
    }));
    CHECK(rc::check("divisors", [](const Integer& a, const Integer& b) {
        const Integer d = gcd(a, b);
        RC_ASSERT(sign(d) >= 0);
        RC_ASSERT(lcm(a, b) * d == abs(a * b));
        if (d != 0) RC_ASSERT(gcd(exact_divide(a, d), exact_divide(b, d)) == 1);
    }));
    CHECK(rc::check("powers", [](const Integer& a) {
        const auto m = static_cast<std::uint64_t>(*rc::gen::inRange(0, 12));
        const auto n = static_cast<std::uint64_t>(*rc::gen::inRange(0, 12));
        RC_ASSERT(power(a, m) * power(a, n) == power(a, m + n));
    }));
}

TEST_CASE("a number survives copying, moving and aliasing") {
    CHECK(rc::check([](const Integer& a, const Integer& b) {
        Integer copy = a;
        Integer other = b;
        swap(copy, other);
        RC_ASSERT(copy == b);
        RC_ASSERT(other == a);
        copy = other;
        RC_ASSERT(copy == a);
        Integer moved = std::move(other);
        RC_ASSERT(moved == a);
        const Integer& same = moved;
        moved = same;
        RC_ASSERT(moved == a);
        moved += same;
        RC_ASSERT(moved == 2 * a);
        moved *= same;
        RC_ASSERT(moved == 4 * a * a);
        moved -= same;
        RC_ASSERT(moved.is_zero());
    }));
}

TEST_CASE("text") {
    CHECK(rc::check("round trip", [](const Integer& a) {
        RC_ASSERT(Integer(to_string(a)) == a);
        std::ostringstream out;
        out << a;
        RC_ASSERT(out.str() == to_string(a));
    }));
    CHECK(Integer("+007") == 7);
    CHECK(Integer("-0") == 0);
    for (const char* text : {"", "-", "+", "1 2", " 1", "1 ", "--1", "0x10", "1.0", "1e3", "٣"}) {
        CAPTURE(text);
        CHECK_THROWS_WITH_AS(Integer{text},
                             ("expected an integer, found \"" + std::string(text) + "\"").c_str(),
                             Error);
    }
    CHECK_THROWS_AS(Integer(std::string_view("1\0002", 3)), Error);
    const std::string nines(200'000, '9');
    CHECK(to_string(Integer(nines)) == nines);
    CHECK(Integer(nines) + 1 == power(Integer(10), 200'000));
}

TEST_CASE("size, parity, sign") {
    CHECK(rc::check([](const Integer& a) {
        RC_ASSERT(a.is_even() == (remainder(a, 2) == 0));
        RC_ASSERT(abs(a) * sign(a) == a);
        const std::uint64_t bits = bit_length(a);
        RC_ASSERT(abs(a) < power(Integer(2), bits));
        if (bits > 0) RC_ASSERT(abs(a) >= power(Integer(2), bits - 1));
        RC_ASSERT(a.fits_int64() == (a >= std::numeric_limits<std::int64_t>::min() &&
                                     a <= std::numeric_limits<std::int64_t>::max()));
        RC_ASSERT(a.fits_uint64() == (a >= 0 && a <= std::numeric_limits<std::uint64_t>::max()));
        if (!a.fits_int64()) RC_ASSERT_THROWS_AS(a.to_int64(), Error);
        if (!a.fits_uint64()) RC_ASSERT_THROWS_AS(a.to_uint64(), Error);
    }));
    CHECK_THROWS_WITH_AS(Integer(-1).to_uint64(),
                         "expected a number from 0 of at most 64 binary digits, found -1", Error);
}

TEST_CASE("the nearest double") {
    const auto exact = [](double x) {  // an integral double as an Integer
        int exponent = 0;
        const double mantissa = std::ldexp(std::frexp(x, &exponent), 53);
        const Integer whole(static_cast<std::int64_t>(mantissa));
        const Integer scale =
            power(Integer(2), static_cast<std::uint64_t>(std::abs(exponent - 53)));
        return exponent >= 53 ? whole * scale : exact_divide(whole, scale);
    };
    CHECK(rc::check([&](const Integer& a) {
        RC_PRE(bit_length(a) < 1000);
        const double x = a.to_double();
        const Integer error = abs(exact(x) - a);
        for (const double neighbour : {std::nextafter(x, HUGE_VAL), std::nextafter(x, -HUGE_VAL)})
            if (neighbour == std::floor(neighbour)) RC_ASSERT(error <= abs(exact(neighbour) - a));
    }));
    const Integer top = power(Integer(2), 53);
    CHECK((top + 1).to_double() == 0x1p53);  // ties to even
    CHECK((top + 3).to_double() == 0x1p53 + 4);
    CHECK((power(Integer(2), 200) + power(Integer(2), 147)).to_double() == 0x1p200);
    CHECK((power(Integer(2), 200) + power(Integer(2), 147) + 1).to_double() == 0x1p200 + 0x1p148);
    CHECK(power(Integer(2), 1024).to_double() == HUGE_VAL);
    CHECK((power(Integer(2), 1024) - power(Integer(2), 970)).to_double() == HUGE_VAL);
    CHECK((power(Integer(2), 1024) - power(Integer(2), 970) - 1).to_double() ==
          std::numeric_limits<double>::max());
    CHECK((-power(Integer(10), 400)).to_double() == -HUGE_VAL);
}

TEST_CASE("equal numbers have equal hashes, different ones hardly ever") {
    CHECK(rc::check([](const Integer& a, const Integer& b) {
        RC_ASSERT(hash_value(a + b - b) == hash_value(a));
    }));
    std::unordered_set<std::size_t> hashes;
    for (int i = -5000; i < 5000; ++i) hashes.insert(std::hash<Integer>()(i));
    for (unsigned i = 63; i < 163; ++i) hashes.insert(hash_value(power(Integer(2), i)));
    CHECK(hashes.size() == 10100);
}

TEST_CASE("what is impossible or too large is refused, not attempted") {
    CHECK_THROWS_WITH_AS(floor_divide(1, 0), "expected a divisor other than 0, found 0", Error);
    CHECK_THROWS_AS(remainder(Integer(1), 0), Error);
    CHECK_THROWS_AS(exact_divide(0, 0), Error);
    CHECK_THROWS_AS(power(Integer(2), std::uint64_t{1} << 40), BoundReached);
    CHECK_THROWS_AS(power(Integer(-10), std::numeric_limits<std::uint64_t>::max()), BoundReached);
    CHECK(power(Integer(1), std::numeric_limits<std::uint64_t>::max()) == 1);
    CHECK(power(Integer(-1), std::numeric_limits<std::uint64_t>::max()) == -1);
    CHECK(power(Integer(0), std::numeric_limits<std::uint64_t>::max()) == 0);
    CHECK(power(Integer(0), 0) == 1);
}
