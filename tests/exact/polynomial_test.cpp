#include "exact/exact.hpp"

#include <doctest/doctest.h>

#include "exact/any_numbers.hpp"

using namespace algae;

namespace {

Polynomial product(const Factorisation& factors) {
    Polynomial result = factors.content;
    for (const auto& [factor, exponent] : factors.powers) result *= power(factor, exponent);
    return result;
}

/// value at a matrix, by Horner's rule.
IntegerMatrix at(const Polynomial& value, const IntegerMatrix& matrix) {
    IntegerMatrix result(matrix.rows(), matrix.rows());
    for (std::size_t i = value.coefficients().size(); i-- > 0;) {
        result = result * matrix;
        for (std::size_t k = 0; k < matrix.rows(); ++k) result(k, k) += value.coefficient(i);
    }
    return result;
}

}  // namespace

TEST_CASE("evaluation is a homomorphism") {
    CHECK(rc::check([](const Integer& x) {
        const Polynomial p = any_polynomial(8), q = any_polynomial(8);
        RC_ASSERT((p + q)(x) == p(x) + q(x));
        RC_ASSERT((p - q)(x) == p(x) - q(x));
        RC_ASSERT((p * q)(x) == p(x) * q(x));
        RC_ASSERT((-p)(x) == -p(x));
        RC_ASSERT(p(Rational(x)) == p(x));
        RC_ASSERT(p(Ball(x, 64)).contains(p(x)));
        RC_ASSERT(power(p, 3) == p * p * p);
        RC_ASSERT(derivative(p * q) == derivative(p) * q + p * derivative(q));
        RC_ASSERT((p * q).degree() == (p.is_zero() || q.is_zero() ? -1 : p.degree() + q.degree()));
    }));
}

TEST_CASE("division and common divisors") {
    CHECK(rc::check([] {
        const Polynomial p = any_polynomial(6), q = any_polynomial(6), r = any_polynomial(6);
        if (!q.is_zero()) RC_ASSERT(exact_divide(p * q, q) == p);
        RC_ASSERT(primitive_part(p) *
                      (sign(p.leading_coefficient()) < 0 ? -content(p) : content(p)) ==
                  p);
        const Polynomial d = gcd(p * r, q * r);
        if (!d.is_zero()) {
            RC_ASSERT(exact_divide(p * r, d).has_value());
            RC_ASSERT(exact_divide(q * r, d).has_value());
            RC_ASSERT(exact_divide(d, primitive_part(r)).has_value());
        }
        const Polynomial monic = q + Polynomial::monomial(1, 7);
        const Polynomial rest = remainder(p * r, monic);
        RC_ASSERT(rest.degree() < 7);
        RC_ASSERT(exact_divide(p * r - rest, monic).has_value());
        RC_ASSERT(is_squarefree(p * p) == (p.degree() == 0));
    }));
    CHECK(!exact_divide(Polynomial({1, 1}), Polynomial({0, 2})));
    CHECK_THROWS_AS(exact_divide(Polynomial({1, 1}), Polynomial()), Error);
    CHECK_THROWS_AS(remainder(Polynomial({1, 1}), Polynomial({0, 2})), Error);
}

TEST_CASE("factors multiply back and do not factor further") {
    CHECK(rc::check([] {
        const Polynomial p =
            any_polynomial(0, 4) * any_polynomial(0, 4) * power(any_polynomial(0, 2), 2);
        const Factorisation factors = factorise(p);
        RC_ASSERT(product(factors) == p);
        for (const auto& [factor, exponent] : factors.powers) {
            RC_ASSERT(factor.degree() > 0);
            RC_ASSERT(content(factor) == 1);
            RC_ASSERT(sign(factor.leading_coefficient()) > 0);
            RC_ASSERT(factorise(factor).powers.size() == 1u);
        }
    }));
    const Factorisation factors = factorise(Polynomial({-2, 0, 2}));
    CHECK(factors.content == 2);
    CHECK(factors.powers ==
          std::vector<Factorisation::Power>{{Polynomial({-1, 1}), 1}, {Polynomial({1, 1}), 1}});
    CHECK(factorise(-3).content == -3);
    CHECK(factorise(Polynomial({2, -1})).content == -1);
    CHECK_THROWS_AS(factorise(0), Error);
}

TEST_CASE("cyclotomic polynomials multiply to x^n - 1") {
    for (long n = 1; n <= 120; ++n) {
        Polynomial all = 1;
        for (long d = 1; d <= n; ++d)
            if (n % d == 0) all *= cyclotomic_polynomial(d);
        CHECK(all == Polynomial::monomial(1, static_cast<std::size_t>(n)) - 1);
        CHECK(cyclotomic_order(cyclotomic_polynomial(n)) == static_cast<unsigned long>(n));
    }
    CHECK(!cyclotomic_order(Polynomial({-1, -1, 1})));
    CHECK(!cyclotomic_order(0));
    CHECK_THROWS_AS(cyclotomic_polynomial(0), Error);
    CHECK_THROWS_AS(cyclotomic_polynomial(2'000'000'000), Error);
}

TEST_CASE("roots are roots, all of them, apart") {
    CHECK(rc::check([] {
        const Polynomial p = any_polynomial(1, 5);
        const auto found = roots(p, 80);
        unsigned count = 0;
        Ball sum(0, 80);
        for (const Root& root : found) {
            count += root.multiplicity;
            sum += root.real * Ball(root.multiplicity, 80);
            if (root.is_real) RC_ASSERT(p(root.real).contains(Rational(0)));
            RC_ASSERT(root.real.has_radius_below(-40));
        }
        RC_ASSERT(static_cast<long>(count) == p.degree());
        // Vieta: the sum of the roots
        RC_ASSERT(sum.contains(Rational(-p.coefficient(static_cast<std::size_t>(p.degree() - 1)),
                                        p.leading_coefficient())));
    }));
    const auto golden = roots(Polynomial({-1, -1, 1}), 128);
    REQUIRE(golden.size() == 2);
    CHECK(golden[0].is_real);
    const auto close = roots(Polynomial({-1, 1}) * Polynomial({-1000001, 1000000}), 4);
    CHECK(!close[0].real.overlaps(close[1].real));
}

TEST_CASE("the matrix is a root of its characteristic and minimal polynomial") {
    CHECK(rc::check([] {
        const auto size = *rc::gen::inRange<std::size_t>(0, 5);
        const IntegerMatrix matrix = any_matrix(size, size);
        const Polynomial characteristic = characteristic_polynomial(matrix);
        RC_ASSERT(characteristic.degree() == static_cast<long>(size));
        RC_ASSERT(at(characteristic, matrix).is_zero());
        RC_ASSERT(characteristic(Integer(0)) == determinant(matrix) * (size % 2 == 0 ? 1 : -1));
        const Polynomial minimal = minimal_polynomial(matrix);
        RC_ASSERT(at(minimal, matrix).is_zero());
        RC_ASSERT(minimal.leading_coefficient() == 1);
        RC_ASSERT(exact_divide(characteristic, minimal).has_value());
    }));
    CHECK(minimal_polynomial(IntegerMatrix(2, 2)) == Polynomial({0, 1}));  // FLINT 2.9 says 1
    CHECK(minimal_polynomial(IntegerMatrix(1, 1)) == Polynomial({0, 1}));
    CHECK(minimal_polynomial(IntegerMatrix::identity(4)) == Polynomial({-1, 1}));
    CHECK(characteristic_polynomial(IntegerMatrix({{1, 1}, {1, 0}})) == Polynomial({-1, -1, 1}));
    CHECK_THROWS_AS(characteristic_polynomial(IntegerMatrix(1, 2)), Error);
    CHECK_THROWS_AS(minimal_polynomial(IntegerMatrix(1, 2)), Error);
}

TEST_CASE("text") {
    CHECK(to_string(Polynomial({-1, -1, 1})) == "x^2 - x - 1");
    CHECK(to_string(Polynomial({0, 3, 0, -2}), "n") == "-2n^3 + 3n");
    CHECK(to_string(Polynomial()) == "0");
    CHECK(to_string(Polynomial(-1)) == "-1");
    CHECK(to_string(Polynomial({0, -1})) == "-x");
    CHECK(Polynomial({5}) == Polynomial(5));
}
