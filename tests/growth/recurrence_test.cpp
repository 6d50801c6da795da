#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <map>

#include "growth/counted.hpp"
#include "growth/growth.hpp"

using namespace algae;

namespace {

/// The rank of the matrix a(i + j), as many rows and columns as the system has letters: the least
/// order of a recurrence that holds from the start (Kronecker).
std::size_t hankel_rank(const std::vector<Integer>& values, std::size_t size) {
    IntegerMatrix matrix(size, size);
    for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j) matrix(i, j) = values[i + j];
    return rank(matrix);
}

void check_recurrence(const D0L& system, std::size_t count) {
    const Recurrence found = shortest_recurrence(system);
    const std::vector<Integer> counted = counted_lengths(system, count);
    CHECK(found.values(count) == counted);
    CHECK(found.holds_from() <= system.letters.size());
}

}  // namespace

TEST_CASE("the recurrence gives the lengths counted letter by letter, and none is shorter") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        const Recurrence found = shortest_recurrence(system);
        const std::vector<Integer> counted = counted_lengths(system, 200);
        RC_ASSERT(found.values(200) == counted);
        RC_ASSERT(found.initial.size() == found.holds_from());
        RC_ASSERT(found.holds_from() == hankel_rank(counted, system.letters.size()));
        RC_ASSERT(!found.polynomial.coefficient(0).is_zero());
        RC_ASSERT(found.polynomial.leading_coefficient() == 1);
    }));
}

TEST_CASE("the same for systems of many letters") {
    CHECK(rc::check([] {
        const D0L system = any_wide_system(*rc::gen::inRange<std::size_t>(20, 60));
        const Recurrence found = shortest_recurrence(system);
        RC_ASSERT(found.values(200) == counted_lengths(system, 200));
        RC_ASSERT(found.holds_from() ==
                  hankel_rank(found.values(2 * system.letters.size()), system.letters.size()));
    }));
}

TEST_CASE("every system in the files obeys a recurrence no longer than it has letters") {
    const auto systems = systems_in_files();
    CHECK(systems.size() >= 70);
    for (const D0L& system : systems) {
        CAPTURE(system.name);
        check_recurrence(system, 60);
    }
}

TEST_CASE("the quotient of the generating function gives the lengths and is in lowest terms") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        const GeneratingFunction found = generating_function(shortest_recurrence(system));
        RC_ASSERT(found.denominator.coefficient(0) == 1);
        RC_ASSERT(gcd(found.numerator, found.denominator).degree() <= 0);
        const std::vector<Integer> counted = counted_lengths(system, 60);
        std::vector<Integer> product = (Polynomial(counted) * found.denominator).coefficients();
        product.resize(60);
        for (std::size_t n = 0; n < 60; ++n)
            RC_ASSERT(product[n] == found.numerator.coefficient(n));
    }));
}

TEST_CASE("recurrences and generating functions as they are written") {
    const Recurrence koch = shortest_recurrence(d0l("F", {{'F', "F+F--F+F"}}));
    CHECK(koch.text() == "a(n) = 5a(n-1) - 4a(n-2)");
    CHECK(koch.initial == std::vector<Integer>{1, 8});
    CHECK(to_string(generating_function(koch)) == "(1 + 3x)/(1 - 5x + 4x^2)");
    const Recurrence dying = shortest_recurrence(d0l("a", {{'a', "b"}, {'b', "c"}, {'c', ""}}));
    CHECK(dying.text() == "a(n) = 0");
    CHECK(dying.holds_from() == 3);
    CHECK(to_string(generating_function(dying)) == "1 + x + x^2");
    const Recurrence nothing = shortest_recurrence(d0l("", {{'a', "aa"}}));
    CHECK(nothing.holds_from() == 0);
    CHECK(nothing.values(3) == std::vector<Integer>{0, 0, 0});
    CHECK(to_string(generating_function(nothing)) == "0");
    CHECK(shortest_recurrence(d0l("a", {{'a', "bb"}, {'b', "a"}})).text() == "a(n) = 2a(n-2)");
}

TEST_CASE("the generating function of n 2^n and of 2^n") {
    CHECK(generating_function(shortest_recurrence(d0l("a", {{'a', "aab"}, {'b', "bb"}}))) ==
          GeneratingFunction{Polynomial({1, -1}), Polynomial({1, -4, 4})});
    CHECK(generating_function(shortest_recurrence(d0l("a", {{'a', "ab"}, {'b', "ba"}}))) ==
          GeneratingFunction{Polynomial({1}), Polynomial({1, -2})});
}

TEST_CASE("what annihilates the letter counts annihilates them all, and nothing smaller does") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        const GrowthMatrix matrix = growth_matrix(system);
        const std::vector<Integer> counts = axiom_counts(system);
        const Polynomial found = annihilator(counts, matrix);
        std::vector<Integer> sum(counts.size()), now = counts;
        std::vector<std::vector<Integer>> rows;
        for (std::size_t k = 0; k < found.coefficients().size(); ++k) {
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += found.coefficients()[k] * now[i];
            rows.push_back(now);
            now = now * matrix;
        }
        RC_ASSERT(sum == std::vector<Integer>(sum.size()));
        rows.pop_back();
        RC_ASSERT(rank(IntegerMatrix(rows)) == rows.size());
    }));
}

TEST_CASE("states that nothing tells apart change no recurrence") {
    std::size_t larger = 0;
    CHECK(rc::check([&] {
        const D0L system = any_small_system();
        const GrowthMatrix matrix = growth_matrix(system);
        const std::vector<Integer> counts = axiom_counts(system), ones(matrix.size(), 1);
        // Each state several times; what leads to it leads to any of them.
        const auto copies = *rc::gen::inRange<std::size_t>(1, 5);
        const auto any_copy = [&](std::size_t state) {
            return state * copies + *rc::gen::inRange<std::size_t>(0, copies);
        };
        GrowthMatrix blown;
        std::vector<Integer> row(matrix.size() * copies);
        for (std::size_t i = 0; i < matrix.size(); ++i) {
            for (std::size_t copy = 0; copy < copies; ++copy) {
                std::map<std::size_t, Integer> entries;
                for (const auto& [column, times] : matrix.rows[i])
                    for (Integer left = times; !left.is_zero(); left -= 1)
                        entries[any_copy(column)] += 1;
                auto& into = blown.rows.emplace_back();
                for (const auto& [column, times] : entries) into.push_back({column, times});
            }
            row[any_copy(i)] += counts[i];
        }
        larger += copies > 1 ? 1 : 0;
        RC_ASSERT(annihilator(row, blown, std::vector<Integer>(row.size(), 1)) ==
                  annihilator(counts, matrix, ones));
    }));
    CHECK(larger > 30);
}

TEST_CASE("primes and inverses") {
    CHECK(prime_below(std::uint64_t{1} << 61) == (std::uint64_t{1} << 61) - 1);
    CHECK(prime_below(100) == 97);
    CHECK(prime_below(4) == 3);
    const PrimeField field(prime_below(std::uint64_t{1} << 61));
    for (const Residue x : {Residue{1}, Residue{2}, Residue{12345678901234567}})
        CHECK(field.multiply(x, field.inverse(x)) == 1);
    CHECK(field.residue(Integer(-1)) == field.prime() - 1);
}

TEST_CASE(
    "sequences whose beginning is simpler than they are have the recurrence of all of their "
    "terms") {
    std::size_t late = 0;
    CHECK(rc::check([&] {
        // A chain of states that leads to a small system: until then there is one letter.
        const D0L system = any_small_system();
        const GrowthMatrix small = growth_matrix(system);
        const auto chain = *rc::gen::inRange<std::size_t>(0, 250);
        GrowthMatrix matrix;
        for (std::size_t i = 0; i < chain; ++i) matrix.rows.push_back({{i + 1, Integer(1)}});
        for (const auto& entries : small.rows) {
            auto& row = matrix.rows.emplace_back();
            for (const auto& [to, times] : entries) row.push_back({to + chain, times});
        }
        std::vector<Integer> row(matrix.size()), column(matrix.size(), 1);
        row[0] = 1;
        const Polynomial found = annihilator(row, matrix, column);
        late += chain > 80 ? 1 : 0;
        const PrimeField field(prime_below(Residue{1} << 60));
        std::vector<Residue> terms;
        std::vector<Integer> now = row;
        for (std::size_t n = 0; n < 2 * matrix.size(); ++n) {
            Integer sum = 0;
            for (const Integer& x : now) sum += x;
            terms.push_back(field.residue(sum));
            now = now * matrix;
        }
        std::vector<Residue> coefficients;
        for (const Integer& x : found.coefficients()) coefficients.push_back(field.residue(x));
        RC_ASSERT(coefficients == shortest_recurrence_modulo(terms, field));
    }));
    CHECK(late > 10);
}
