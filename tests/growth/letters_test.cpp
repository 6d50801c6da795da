#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "growth/counted.hpp"
#include "growth/growth.hpp"

using namespace algae;

namespace {

Word rewritten(const D0L& system, Word word, std::uint64_t n) {
    for (; n > 0; --n) {
        Word next;
        for (const Symbol a : word)
            next.insert(next.end(), system.successor(a).begin(), system.successor(a).end());
        word = std::move(next);
    }
    return word;
}

D0L from(const D0L& system, Symbol a) {
    return make_d0l(system.alphabet, Word{a}, system.rules.images());
}

}  // namespace

TEST_CASE("letters die when their words say so") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        const auto found = lifetimes(growth_matrix(system));
        for (std::size_t i = 0; i < system.letters.size(); ++i) {
            const std::vector<Integer> values =
                counted_lengths(from(system, system.letters[i]), 12);
            const auto empty = std::find(values.begin(), values.end(), Integer(0));
            RC_ASSERT(found[i].has_value() == (empty != values.end()));
            if (found[i]) RC_ASSERT(static_cast<std::int64_t>(*found[i]) == empty - values.begin());
        }
    }));
}

TEST_CASE("each letter grows as a system that begins with it") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        const auto found = letter_orders(components(growth_matrix(system)));
        for (std::size_t i = 0; i < system.letters.size(); ++i)
            RC_ASSERT(found[i] == growth_class(from(system, system.letters[i])).order);
    }));
}

TEST_CASE("letters that begin their own words, by rewriting") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        const auto found = prolongations(system);
        for (const Symbol a : system.letters) {
            std::uint64_t power = 0;
            bool fixed = false;
            for (std::uint64_t p = 1; p <= 6 && power == 0; ++p) {
                const Word word = rewritten(system, {a}, p);
                if (word.empty() || word.front() != a) continue;
                power = p;
                fixed = word.size() == 1;
            }
            const auto known = std::find_if(found.begin(), found.end(),
                                            [&](const auto& point) { return point.letter == a; });
            RC_ASSERT((known == found.end()) == (power == 0));
            if (power == 0) continue;
            RC_ASSERT(known->power == power);
            RC_ASSERT(known->fixed == fixed);
            const std::vector<Integer> values = counted_lengths(from(system, a), 16 * power);
            RC_ASSERT(known->infinite == (values[15 * power] > values[14 * power]));
        }
    }));
}

TEST_CASE("primitivity by powers of the full matrix") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        const std::size_t size = system.letters.size();
        const IntegerMatrix matrix = incidence_matrix(system);
        std::optional<std::uint64_t> exponent;
        IntegerMatrix now = IntegerMatrix::identity(size), sum(size, size);
        for (std::uint64_t k = 1; k <= size * size + 1; ++k) {
            now = now * matrix;
            sum += now;
            bool full = true;
            for (std::size_t i = 0; i < size; ++i)
                for (std::size_t j = 0; j < size; ++j) full = full && !now(i, j).is_zero();
            if (full && !exponent) exponent = k;
        }
        bool irreducible = true;
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t j = 0; j < size; ++j)
                irreducible = irreducible && !sum(i, j).is_zero();
        const Primitivity found = primitivity(growth_matrix(system));
        RC_ASSERT(found.irreducible == irreducible);
        RC_ASSERT(found.exponent == exponent);
    }));
    CHECK(primitivity(growth_matrix(d0l("a", {{'a', "ab"}, {'b', "a"}}))).exponent == 2);
    CHECK(!primitivity(growth_matrix(d0l("a", {{'a', "bb"}, {'b', "a"}}))).exponent);
    // Wielandt's matrices need the most: (letters - 1)^2 + 1.
    CHECK(primitivity(growth_matrix(d0l("a", {{'a', "b"}, {'b', "c"}, {'c', "d"}, {'d', "ab"}})))
              .exponent == 10);
}

TEST_CASE("the shares of letters come close to their limits") {
    CHECK(rc::check([] {
        const D0L system = any_small_system();
        const LetterFrequencies found = letter_frequencies(system);
        RC_TAG(to_string(found.period));
        if (found.limits.empty()) return;
        RC_ASSERT(found.limits.size() == found.period.to_uint64());
        for (std::uint64_t r = 0; r < found.limits.size(); ++r) {
            const std::uint64_t n = 24000 / found.limits.size() * found.limits.size() + r;
            const std::vector<Integer> counts = parikh_vector(system, n);
            Integer sum;
            for (const Integer& count : counts) sum += count;
            for (std::size_t i = 0; i < counts.size(); ++i) {
                const double share = Rational(counts[i], sum).to_double();
                RC_ASSERT(std::abs(share - found.limits[r][i].enclosure(64).midpoint()) < 2e-3);
            }
        }
    }));
}

TEST_CASE("shares as they are written") {
    const auto shares = [](const D0L& system) {
        std::vector<std::string> found;
        for (const auto& limit : letter_frequencies(system).limits)
            for (const Frequency& frequency : limit) found.push_back(frequency.exact());
        return found;
    };
    using Shares = std::vector<std::string>;
    CHECK(shares(d0l("F", {{'F', "F+F--F+F"}})) == Shares{"3/7", "2/7", "2/7"});
    CHECK(shares(d0l("a", {{'a', "ab"}, {'b', "a"}})) == Shares{"(-1+sqrt(5))/2", "(3-sqrt(5))/2"});
    CHECK(shares(d0l("a", {{'a', "bb"}, {'b', "a"}})) == Shares{"1", "0", "0", "1"});
    CHECK(shares(d0l("c", {{'a', "c"}, {'b', "ca"}, {'c', "b"}})) ==
          Shares{"r^2 - r", "r - 1", "-r^2 + 2"});
    CHECK(shares(d0l("a", {{'a', ""}})).empty());
    const D0L padovan = d0l("c", {{'a', "c"}, {'b', "ca"}, {'c', "b"}});
    CHECK(letter_frequencies(padovan).limits[0][0].decimal(10) == "0.4301597090");
}

TEST_CASE("letter counts of the fibonacci word") {
    CHECK(parikh_vector(d0l("a", {{'a', "ab"}, {'b', "a"}}), 30) ==
          std::vector<Integer>{1346269, 832040});
}

TEST_CASE("an analysis of every system in the files holds together") {
    for (const D0L& system : systems_in_files()) {
        CAPTURE(system.name);
        const GrowthAnalysis found = growth_analysis(system);
        CHECK(found.lengths == counted_lengths(system, 11));
        CHECK(found.letters.size() == system.letters.size());
        CHECK(exact_divide(found.polynomials.minimal, found.recurrence.polynomial).has_value());
        if (found.frequencies.limits.empty()) continue;
        Ball sum(0, 128);
        for (const Frequency& frequency : found.frequencies.limits[0])
            sum += frequency.enclosure(128);
        CHECK(sum.contains(Rational(1)));
    }
}
