#include "dimension/detail/ratio_graph.hpp"
#include "dimension/detail/recurrent_set.hpp"
#include "dimension/dimension.hpp"
#include "growth/growth.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <complex>
#include <string>
#include <utility>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

DimensionValue logs(long a, long b, const Rational& factor = Rational(1)) {
    return DimensionValue(factor, AlgebraicInteger(Integer(a)), AlgebraicInteger(Integer(b)));
}

AlgebraicInteger root(std::initializer_list<Integer> polynomial) {
    return *AlgebraicInteger::largest_root(Polynomial(polynomial));
}

}  // namespace

TEST_CASE("roots of integers are told apart, and their powers found") {
    CHECK(power(root({-10, 0, 1}), 4).integer() == Integer(100));
    CHECK(power(root({-1, -1, 1}), 2) == root({1, -3, 1}));
    CHECK(root({-2, -1, 0, 1}) != root({-1, -1, 0, 1}));
    CHECK(!AlgebraicInteger::largest_root(Polynomial({1, 0, 1})));
    CHECK(!AlgebraicInteger::largest_root(Polynomial({1, 1})));
    const AlgebraicInteger golden = root({-1, -1, 1});
    CHECK(exponent_between(power(golden, 6), power(golden, 4)) == Rational(3, 2));
    CHECK(!exponent_between(golden, AlgebraicInteger(Integer(2))));
    CHECK(!exponent_between(golden, AlgebraicInteger(Integer(1))));
}

TEST_CASE("logarithms of powers with matching exponents are equal, exactly") {
    CHECK(compare(logs(4, 3), logs(16, 9)) == Order::equal);
    CHECK(compare(logs(8, 4), Rational(3, 2)) == Order::equal);
    CHECK(compare(logs(2, 3), logs(4, 3, Rational(1, 2))) == Order::equal);
    CHECK(compare(logs(6, 10), logs(8, 10)) == Order::less);
    CHECK(compare(logs(4, 3), Rational("1.26185950714291487419905422868552171")) == Order::less);
    CHECK(compare(Rational(2), Rational(3, 2)) == Order::greater);
    const AlgebraicInteger golden = root({-1, -1, 1});
    CHECK(compare(DimensionValue(Rational(1), power(golden, 3), power(golden, 2)),
                  Rational(3, 2)) == Order::equal);
    CHECK(compare(DimensionValue(Rational(1), golden, AlgebraicInteger(Integer(2))),
                  DimensionValue(Rational(1), power(golden, 2), AlgebraicInteger(Integer(4)))) ==
          Order::equal);
}

TEST_CASE("of random numbers of the form log a^i / log b^j the order is that of the values") {
    CHECK(rc::check([] {
        const auto number = [] {
            const long a = *rc::gen::inRange(2, 8), b = *rc::gen::inRange(2, 8);
            const int i = *rc::gen::inRange(1, 4), j = *rc::gen::inRange(1, 4);
            long over = 1, under = 1;
            for (int k = 0; k < i; ++k) over *= a;
            for (int k = 0; k < j; ++k) under *= b;
            return std::pair(logs(over, under), std::log(static_cast<double>(over)) /
                                                    std::log(static_cast<double>(under)));
        };
        const auto [left, x] = number();
        const auto [right, y] = number();
        const Order expected = std::abs(x - y) < 1e-9 ? Order::equal
                               : x < y                ? Order::less
                                                      : Order::greater;
        RC_ASSERT(compare(left, right) == expected);
    }));
}

TEST_CASE("what the rules give is compared with what is claimed") {
    const auto value = [](const char* system) {
        return *exact_dimension(read_lsystem(system, "")).value->log_ratio();
    };
    const LogRatio koch = value("axiom F; F -> F+F--F+F; angle 60");
    CHECK(compare(koch, logs(4, 3)) == Order::equal);
    CHECK(compare(koch, logs(5, 3)) == Order::less);
    const LogRatio island = value("axiom F; F -> F-F+F+FF-F-F+F; angle 90");
    CHECK(compare(island, Rational(3, 2)) == Order::equal);
    CHECK(compare(island, logs(27, 9)) == Order::equal);
}

TEST_CASE("a cyclotomic field has the values of roots and powers that lie in it") {
    struct Case {
        const char* text;
        long order;
        double value;
    };
    const Case cases[] = {
        {"sqrt(2)", 8, std::sqrt(2.0)},
        {"sqrt(8)", 8, std::sqrt(8.0)},
        {"sqrt(12)", 12, std::sqrt(12.0)},
        {"sqrt(75)", 12, std::sqrt(75.0)},
        {"sqrt(5)", 20, std::sqrt(5.0)},
        {"sqrt(49)", 4, 7},
        {"sqrt(16)", 4, 4},
        {"3^(-1/2)", 12, 1 / std::sqrt(3.0)},
        {"(1+sqrt(2))^2", 8, 5.82842712474619},
        {"(1+sqrt(2))^0", 8, 1},
        {"(1+sqrt(2))^(-1)", 8, 0.414213562373095},
        {"-sqrt(3)", 12, -std::sqrt(3.0)},
        {"(1+sqrt(2))/sqrt(2)", 8, 1 + std::sqrt(0.5)},
        {"tan(60)", 12, std::sqrt(3.0)},
        {"cos(60)", 12, 0.5},
        {"sin(30)", 12, 0.5},
    };
    for (const Case& one : cases) {
        CAPTURE(one.text);
        const CyclotomicField field(one.order);
        const auto found = field.value_of(read_expression(one.text));
        REQUIRE(found);
        CHECK(std::abs(field.to_complex(*found) - one.value) < 1e-9);
    }
}

TEST_CASE("a cyclotomic field has no values of roots and powers that lie outside it") {
    const std::pair<const char*, long> cases[] = {
        {"sqrt(2)", 4},
        {"sqrt(2)", 12},
        {"sqrt(3)", 8},
        {"sqrt(5)", 12},
        {"(sqrt(2)-sqrt(2))^(-1)", 8},
        {"(1+sqrt(2))^(1/3)", 8},
        {"1/sqrt(5)", 8},
        {"tan(90)", 4},
        {"(1+sqrt(2))^(1/2)", 8},
    };
    for (const auto& [text, order] : cases) {
        CAPTURE(text);
        CHECK_FALSE(CyclotomicField(order).value_of(read_expression(text)));
    }
}

TEST_CASE("an integer is raised to powers that are too large for other roots") {
    CHECK(power(AlgebraicInteger(Integer(1)), 500).integer() == Integer(1));
    CHECK_THROWS_AS(power(root({-1, -1, 1}), 500), BoundReached);
    CHECK(exponent_between(AlgebraicInteger(Integer(2)), AlgebraicInteger(Integer(8))) ==
          Rational(1, 3));
}

TEST_CASE("the dimension of a carpet is written without logarithms of 1") {
    using Kind = CarpetDimension::Kind;
    CHECK(CarpetDimension(Kind::box, 2, 3, {1, 1}).text().find("log") == std::string::npos);
    CHECK(CarpetDimension(Kind::box, 2, 3, {2, 1}).text() == "1 + log (3/2) / log 3");
    CHECK(CarpetDimension(Kind::hausdorff, 2, 3, {2, 1}).text().find("2^(log 2 / log 3)") !=
          std::string::npos);
}

TEST_CASE("exponents of at most 24 are found, and no larger ones") {
    const AlgebraicInteger two(Integer(2));
    CHECK(exponent_between(AlgebraicInteger(Integer(1L << 24)), two) == Rational(24));
    for (const long exponent : {25, 30, 40}) {
        CAPTURE(exponent);
        CHECK_FALSE(exponent_between(AlgebraicInteger(Integer(1L << exponent)), two));
    }
}

TEST_CASE("a logarithm of a root is a part of that of its power") {
    const AlgebraicInteger under(Integer(1L << 20));
    CHECK(DimensionValue(Rational(1), root({-2, 0, 1}), under).rational() == Rational(1, 40));
    CHECK(DimensionValue(Rational(1), root({-2, 0, 0, 1}), under).rational() == Rational(1, 60));
}

TEST_CASE("a rate of 1 makes the dimension 0") {
    CHECK(LogRatio(Rate(1), ScalingRatio::square_root(Integer(5))).rational() == Rational(0));
}

TEST_CASE("values that are equal by too large exponents are not told apart") {
    const Order order = compare(logs(3, 2), logs(3, 1L << 25, Rational(25)));
    CHECK(order != Order::less);
    CHECK(order != Order::greater);
}

TEST_CASE("the square of a ratio of degree 13 is not worked out") {
    // mu^13 = mu + 1, which is irreducible (Selmer).
    std::string text = "axiom A; M -> AB; interpret M -> F";
    for (char letter = 'A'; letter < 'M'; ++letter) {
        const std::string own(1, letter), next(1, static_cast<char>(letter + 1));
        text += "; " + own + " -> " + next;
        if (letter != 'F') text += "; interpret " + own + " -> F";
    }
    const Model system = read_lsystem(text, "");
    const RecurrentSet set(system, *as_d0l(system));
    const ScalingRatio ratio(set.displacement());
    CHECK_FALSE(ratio.square());
    // So it makes no multiple of a quotient of logarithms.
    CHECK_FALSE(DimensionValue::of(LogRatio(Rate(Integer(5)), ratio)));
}

TEST_CASE("letters that come back after three and four generations have one factor after twelve") {
    // Both become twice as long in each generation on average: 16 times in four, 8 times in three.
    const ExactDimension found = exact_dimension(
        read_lsystem("axiom AP; A -> B; B -> C; C -> D; D -> AAAAAAAAAAAAAAAA; P -> Q; Q -> R; "
                     "R -> PPPPPPPP; interpret A -> F; interpret B -> F; interpret C -> F; "
                     "interpret D -> F; interpret P -> F; interpret Q -> F; interpret R -> F",
                     ""));
    CAPTURE(found.conditions.back());
    REQUIRE(found.value);
    CHECK(found.value->decimal(6) == "1.000000");
}

TEST_CASE("letters that come back after two and five generations have one factor after ten") {
    const ExactDimension found = exact_dimension(read_lsystem(
        "axiom AP; A -> B; B -> AAAA; P -> Q; Q -> R; R -> S; S -> T; T -> " +
            std::string(32, 'P') +
            "; interpret A -> F; interpret B -> F; interpret P -> F; interpret Q -> F; "
            "interpret R -> F; interpret S -> F; interpret T -> F",
        ""));
    CAPTURE(found.conditions.back());
    REQUIRE(found.value);
    CHECK(found.value->decimal(6) == "1.000000");
}

TEST_CASE("a rate that the divisor does not divide stays above it") {
    const ScalingRatio two(Integer(2));
    const Rate golden(Polynomial({-1, -1, 1}), Rational(2));  // (1 + sqrt 5) / 2
    const Rate twice(Polynomial({-4, -2, 1}), Rational(4));
    CHECK(ExpectedRatio(golden, 2, two).average() == "((1+sqrt(5))/2)/2");
    CHECK(ExpectedRatio(golden, 2, two).decimal(6) == "-0.305758");
    CHECK(ExpectedRatio(twice, 2, two).average() == "(1+sqrt(5))/2");
    CHECK(ExpectedRatio(twice, 4, two).average() == "((1+sqrt(5))/2)/2");
    CHECK(ExpectedRatio(twice, 4, two).decimal(6) == "-0.305758");
}

TEST_CASE("each dimension of a carpet is that of its formula") {
    using Kind = CarpetDimension::Kind;
    // Two columns of three kept in one line of three, one in another (McMullen 1984; Mackay 2011; Fraser 2014).
    const auto decimal = [](Kind kind) { return CarpetDimension(kind, 2, 3, {1, 2}).decimal(6); };
    CHECK(decimal(Kind::hausdorff) == "1.349684");
    CHECK(decimal(Kind::box) == "1.369070");
    CHECK(decimal(Kind::assouad) == "1.630930");
    CHECK(decimal(Kind::lower) == "1.000000");
}

TEST_CASE("a matrix of ratios without growth has no m") {
    const Expression third = quantity(Rational(1, 3)).expression;
    const RatioSum sum(2, {{0, 0, third}, {0, 1, third}, {1, 0, third}, {1, 1, third}});
    CHECK(sum.text() == "the matrix of 2 by 2 sums of ratio^s has the spectral radius 1");
    CHECK(sum.decimal(6) == "0.630930");
    const RatioSum one(1, {{0, 0, quantity(Rational(1, 4)).expression}, {0, 0, third}});
    CHECK(one.text() == "0.25^s + (1/3)^s = 1");
}
