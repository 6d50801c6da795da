#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "growth/counted.hpp"
#include "growth/growth.hpp"

using namespace algae;

namespace {

GrowthClass class_of_rules(const std::string& axiom,
                           const std::vector<std::pair<char, std::string>>& rules) {
    return growth_class(d0l(axiom, rules));
}

/// The least p and then the least s with a(n + p) == a(n) for n >= s, looked up in the values.
std::pair<std::size_t, std::size_t> observed_period(const std::vector<Integer>& values) {
    for (std::size_t p = 1;; ++p) {
        std::size_t s = values.size() - p;
        while (s > 0 && values[s - 1] == values[s - 1 + p]) --s;
        if (s < values.size() / 2) return {p, s};
    }
}

/// a(n)/(n^k rho^n), in floating point.
double scaled(const Integer& value, std::size_t n, const GrowthOrder& order) {
    const Ball exact = log(Ball(value, 64)) - Ball(n, 64) * log(order.rate.enclosure(64));
    return std::exp(exact.midpoint() -
                    static_cast<double>(order.degree) * std::log(static_cast<double>(n)));
}

unsigned multiplicity(Polynomial value, const Polynomial& factor) {
    unsigned times = 0;
    for (auto quotient = exact_divide(value, factor); quotient;
         quotient = exact_divide(value, factor)) {
        value = *quotient;
        ++times;
    }
    return times;
}

}  // namespace

TEST_CASE("the class agrees with the lengths") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        const Recurrence recurrence = shortest_recurrence(system);
        const GrowthClass found = growth_class(system);
        const std::vector<Integer> values = counted_lengths(system, 140);
        RC_TAG(to_string(found.order.kind));
        switch (found.order.kind) {
            case GrowthKind::zero:
                for (std::size_t n = 0; n < values.size(); ++n)
                    RC_ASSERT(values[n].is_zero() == (n >= found.preperiod));
                break;
            case GrowthKind::bounded: {
                const auto [period, preperiod] = observed_period(values);
                RC_ASSERT(found.period == Integer(period));
                RC_ASSERT(found.preperiod == preperiod);
                RC_ASSERT(!values.back().is_zero());
                break;
            }
            case GrowthKind::polynomial: {
                // 60 is a common multiple of all cycles of up to 6 letters: differences in steps of 60.
                std::vector<Integer> differences = counted_lengths(system, 60 * 8 + 10);
                differences.erase(differences.begin(), differences.begin() + 9);
                for (std::uint64_t k = 0; k <= found.order.degree; ++k) {
                    RC_ASSERT(!differences[0].is_zero());
                    for (std::size_t n = 0; n + 60 < differences.size(); ++n)
                        differences[n] = differences[n + 60] - differences[n];
                    differences.resize(differences.size() - 60);
                }
                for (const Integer& rest : differences) RC_ASSERT(rest.is_zero());
                break;
            }
            case GrowthKind::exponential: {
                const std::size_t n = 1200;
                const std::vector<Integer> more = counted_lengths(system, 2 * n + 1);
                const double quotient =
                    scaled(more[2 * n], 2 * n, found.order) / scaled(more[n], n, found.order);
                RC_ASSERT(quotient > 0.6);
                RC_ASSERT(quotient < 1.6);
                break;
            }
        }
        if (found.order.kind == GrowthKind::exponential ||
            found.order.kind == GrowthKind::polynomial)
            RC_ASSERT(multiplicity(recurrence.polynomial, found.order.rate.minimal_polynomial()) ==
                      found.order.degree + 1);
        if (found.order.kind == GrowthKind::exponential ||
            found.order.kind == GrowthKind::polynomial || found.order.kind == GrowthKind::bounded)
            for (const auto& power : factorise(recurrence.polynomial).powers)
                for (const Root& root : roots(power.factor, 64)) {
                    // No root of the recurrence is larger, and none as large occurs more often.
                    const Ball size = sqrt(root.real * root.real + root.imaginary * root.imaginary);
                    const Order order = compare(size, found.order.rate.enclosure(64));
                    RC_ASSERT(order != Order::greater);
                    if (order == Order::unknown)
                        RC_ASSERT(power.exponent <= found.order.degree + 1);
                }
    }));
}

TEST_CASE("the period of the limits is the one that the numbers show") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        const GrowthClass found = growth_class(system);
        if (found.order.kind != GrowthKind::exponential || found.order.degree != 0) return;
        const std::size_t n = 1200;
        const std::vector<Integer> values = counted_lengths(system, n + 60);
        const auto has_period = [&](std::size_t p) {
            for (std::size_t r = 0; r < 30; ++r)
                if (std::abs(scaled(values[n + r], n + r, found.order) /
                                 scaled(values[n + r + p], n + r + p, found.order) -
                             1) > 1e-7)
                    return false;
            return true;
        };
        std::size_t least = 1;
        while (!has_period(least) && least < 30) ++least;
        RC_TAG(least);
        RC_ASSERT(found.period == Integer(least));
    }));
}

TEST_CASE("classes known from the theory") {
    const auto terminating = class_of_rules("a", {{'a', "b"}, {'b', "c"}, {'c', ""}});
    CHECK(terminating.order.kind == GrowthKind::zero);
    CHECK(terminating.preperiod == 3);

    const auto mortal =
        class_of_rules("a", {{'a', "bc"}, {'b', "cac"}, {'c', "de"}, {'d', ""}, {'e', ""}});
    CHECK(mortal.order.kind == GrowthKind::bounded);
    CHECK(mortal.preperiod == 2);
    CHECK(mortal.period == 2);

    const auto cycle = class_of_rules("a", {{'a', "bc"}, {'b', "a"}});
    CHECK(cycle.order == GrowthOrder{GrowthKind::polynomial, 1, Rate(1)});

    CHECK(class_of_rules("a", {{'a', "a"}, {'z', "zz"}}).order.kind ==
          GrowthKind::bounded);  // z is not reached
    CHECK(class_of_rules("a", {{'a', "ab"}, {'b', ""}}).order.kind == GrowthKind::bounded);
    CHECK(class_of_rules("a", {{'a', "ab"}, {'b', "c"}, {'c', ""}}).preperiod == 2);
    CHECK(class_of_rules("a", {{'a', "ab"}, {'b', "bc"}, {'c', "cd"}}).order ==
          GrowthOrder{GrowthKind::polynomial, 3, Rate(1)});
    CHECK(class_of_rules("a", {{'a', "aab"}, {'b', "bb"}}).order ==
          GrowthOrder{GrowthKind::exponential, 1, Rate(2)});
    CHECK(class_of_rules("a", {{'a', "ab"}, {'b', "ba"}}).order ==
          GrowthOrder{GrowthKind::exponential, 0, Rate(2)});
    CHECK(class_of_rules("", {{'a', "aa"}}).order.kind == GrowthKind::zero);

    const auto chain = class_of_rules("x", {{'x', "xya"}, {'y', "x"}, {'a', "ab"}, {'b', "a"}});
    CHECK(chain.order.text() == "n*((1+sqrt(5))/2)^n");
    CHECK(chain.period == 1);
    const auto turns = class_of_rules("a", {{'a', "bb"}, {'b', "a"}});
    CHECK(turns.order.text() == "sqrt(2)^n");
    CHECK(turns.period == 2);
    // Two components whose rates are the same number, sqrt(2), from cycles of 2 and of 4 letters.
    const auto fourfold = class_of_rules(
        "ax", {{'a', "bb"}, {'b', "a"}, {'x', "yy"}, {'y', "z"}, {'z', "tt"}, {'t', "x"}});
    CHECK(fourfold.order.rate.exact() == "sqrt(2)");
    CHECK(fourfold.order.degree == 0);
    // A cycle of two whose lengths have a limit all the same: both letters double.
    CHECK(class_of_rules("a", {{'a', "bb"}, {'b', "aa"}}).period == 1);
}

TEST_CASE("rates as they are written") {
    const auto rate = [](const std::string& axiom,
                         const std::vector<std::pair<char, std::string>>& rules) {
        return class_of_rules(axiom, rules).order.rate;
    };
    const Rate golden = rate("a", {{'a', "ab"}, {'b', "a"}});
    CHECK(golden.exact() == "(1+sqrt(5))/2");
    CHECK(golden.decimal(30) == "1.61803398874989484820458683437");
    const Rate padovan = rate("c", {{'a', "c"}, {'b', "ca"}, {'c', "b"}});
    CHECK(padovan.exact() == "the largest real root of x^3 - x - 1");
    CHECK(padovan.decimal(30) == "1.32471795724474602596090885448");
    CHECK(rate("a", {{'a', "bbb"}, {'b', "cc"}, {'c', "a"}}).exact() == "6^(1/3)");
    CHECK(rate("a", {{'a', "aaa"}}).decimal(30) == "3");
    // Fibonacci with a rest after every step.
    CHECK(rate("a", {{'a', "x"}, {'b', "y"}, {'x', "ab"}, {'y', "a"}}).exact() ==
          "((1+sqrt(5))/2)^(1/2)");
    CHECK(golden > padovan);
    CHECK(Rate(2) > golden);
    CHECK(golden == rate("z", {{'z', "zy"}, {'y', "x"}, {'x', "yx"}}));
}

TEST_CASE("characteristic and minimal polynomials are those of the full matrix") {
    const auto check = [](const D0L& system) {
        const GrowthMatrix matrix = growth_matrix(system);
        const MatrixPolynomials found = matrix_polynomials(matrix);
        const IntegerMatrix full = dense(matrix);
        const Polynomial minimal = full.is_zero() ? Polynomial({0, 1}) : minimal_polynomial(full);
        return found.characteristic == characteristic_polynomial(full) &&
               found.minimal == (full.rows() == 0 ? Polynomial(1) : minimal) &&
               found.characteristic_factors.powers == factorise(found.characteristic).powers;
    };
    CHECK(rc::check([&] { RC_ASSERT(check(any_small_system())); }));
    for (const D0L& system : systems_in_files()) {
        CAPTURE(system.name);
        CHECK(check(system));
    }
}

TEST_CASE("characteristic polynomials of large components") {
    CHECK(rc::check([] {
        const GrowthMatrix matrix = growth_matrix(any_wide_system(75));
        RC_ASSERT(matrix_polynomials(matrix).characteristic ==
                  characteristic_polynomial(dense(matrix)));
    }));
}

TEST_CASE("components know their letters, their cycles and their rates") {
    const Components found = components(
        growth_matrix(d0l("a", {{'a', "bbc"}, {'b', "a"}, {'c', "cd"}, {'d', "ee"}, {'e', ""}})));
    REQUIRE(found.list.size() == 4);
    const Component& first = found.list[found.of_letter[0]];
    CHECK(first.letters.size() == 2);
    CHECK(first.cyclicity == 2);
    CHECK(first.rate->exact() == "sqrt(2)");
    CHECK(first.below == std::vector<std::size_t>{found.of_letter[2]});
    CHECK(*found.list[found.of_letter[2]].rate == Rate(1));
    CHECK(!found.list[found.of_letter[3]].rate);
}
