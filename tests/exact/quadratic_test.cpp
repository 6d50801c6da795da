// Numbers a + b sqrt(d): against enclosures, and square roots against their squares.

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cstdint>
#include <optional>

#include "exact/exact.hpp"

using namespace algae;

namespace {

Rational random_rational() {
    return Rational(*rc::gen::inRange(-50, 50), *rc::gen::inRange(1, 12));
}

QuadraticNumber random_number(const Integer& radicand) {
    const Rational factor = random_rational();
    return {random_rational(), factor, factor.is_zero() ? Integer(1) : radicand};
}

/// By trying all squares.
bool is_squarefree(std::uint64_t number) {
    for (std::uint64_t k = 2; k * k <= number; ++k)
        if (number % (k * k) == 0) return false;
    return true;
}

}  // namespace

TEST_CASE("sums, products and quotients with one root lie where enclosures say") {
    std::size_t compared = 0;
    CHECK(rc::check([&] {
        const auto [x, y] =
            *rc::gen::resize(100, rc::gen::exec([] {
                                 const Integer radicand = *rc::gen::element(2, 3, 5, 21, 1001);
                                 return std::pair(random_number(radicand), random_number(radicand));
                             }));
        for (const char operation : {'+', '-', '*', '/'}) {
            const auto found = combined(x, operation, y);
            if (!found) {
                RC_ASSERT(operation == '/');
                RC_ASSERT(y.rational.is_zero() && y.factor.is_zero());
                continue;
            }
            RC_ASSERT(found->is_rational() == (found->radicand == 1));
            const Ball left = enclosure(x, 200), right = enclosure(y, 200);
            const Ball wanted = operation == '+'   ? left + right
                                : operation == '-' ? left - right
                                : operation == '*' ? left * right
                                                   : left / right;
            RC_ASSERT(wanted.overlaps(enclosure(*found, 200)));
            RC_ASSERT(enclosure(*found, 200).has_radius_below(-150));
            const auto back = combined(*found,
                                       operation == '+'   ? '-'
                                       : operation == '-' ? '+'
                                       : operation == '*' ? '/'
                                                          : '*',
                                       y);
            RC_ASSERT(!back || *back == x);
            const auto expected = algae::sign(enclosure(*found, 200));
            RC_ASSERT(sign(*found) == expected.value_or(0));
            ++compared;
        }
    }));
    CHECK(compared >= 300);
}

TEST_CASE("roots of different numbers make no such number, and equal numbers have equal hashes") {
    CHECK(!combined({0, 1, 2}, '+', {0, 1, 3}));
    CHECK(combined({0, 1, 2}, '+', {5, 0, 1}) == QuadraticNumber{5, 1, 2});
    CHECK(!combined({1, 0, 1}, '/', {0, 0, 1}));
    CHECK(hash_value(*combined({0, 1, 2}, '*', {0, 1, 2})) == hash_value(QuadraticNumber{2, 0, 1}));
    CHECK(sign(QuadraticNumber{-7, 5, 2}) == 1);
    CHECK(sign(QuadraticNumber{7, -5, 2}) == -1);
    CHECK(sign(QuadraticNumber{}) == 0);
}

TEST_CASE("squares of primes above the cube root of what is left leave the radicand") {
    CHECK(square_root(Rational(25, 18)) == QuadraticNumber{0, Rational(5, 6), 2});
    CHECK(square_root(Rational(50)) == QuadraticNumber{0, 5, 2});
    for (int n = 1; n <= 20'000; ++n)
        CHECK(is_squarefree(square_root(Rational(n))->radicand.to_uint64()));
}

TEST_CASE("the square of a square root is the number, and its radicand has no square") {
    std::size_t found = 0;
    CHECK(rc::check([&] {
        const Rational value = *rc::gen::resize(
            100, rc::gen::exec([] {
                const int scale = *rc::gen::element(10, 1000, 900'000);
                return Rational(*rc::gen::inRange(1, scale), *rc::gen::inRange(1, scale));
            }));
        const auto root = square_root(value);
        RC_ASSERT(root);
        RC_ASSERT(sign(*root) > 0);
        RC_ASSERT((combined(*root, '*', *root) == QuadraticNumber{value, 0, 1}));
        RC_ASSERT(is_squarefree(root->radicand.to_uint64()));
        ++found;
    }));
    CHECK(found >= 100);
    CHECK(square_root(Rational(4, 9)) == QuadraticNumber{Rational(2, 3), 0, 1});
    CHECK(square_root(Rational(999'983)) == QuadraticNumber{0, 1, 999'983});
    CHECK(square_root(Rational(Integer("999966000289"))) == QuadraticNumber{999'983, 0, 1});
    CHECK(!square_root(Rational(-1)));
    CHECK(!square_root(Rational(Integer("1000000000000000000003"))));
}
