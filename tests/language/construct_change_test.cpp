#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "language/construct_any.hpp"
#include "language/detail/construct.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;
using namespace algae::construct_tests;

TEST_CASE("reversed systems have the reversed words and the same form") {
    CHECK(rc::check("reversal", [] {
        const ET0L system =
            any_system({3, *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), 3});
        const ET0L result = reversed(system);
        std::set<Word> backwards;
        for (const Word& word : words_of(system, 4)) backwards.emplace(word.rbegin(), word.rend());
        RC_ASSERT(words_of(result, 4) == backwards);
        RC_ASSERT(family_name(result) == family_name(system));
    }));
}

TEST_CASE("two tables are enough") {
    CHECK(rc::check("two tables", [] {
        const Kind kind{4, *rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), 2};
        const ET0L system = any_system(kind);
        const ET0L result = with_two_tables(system);
        RC_LOG() << text_of(system);
        require_form(result, std::min<std::size_t>(system.tables.size(), 2));
        if (kind.deterministic) RC_ASSERT(is_deterministic(result));
        if (!kind.erasing) RC_ASSERT(is_propagating(result));
        RC_ASSERT(words_of(result, 4) == words_of(system, 4));
    }));
}

TEST_CASE("the powers of a D0L system take turns") {
    CHECK(rc::check("powers", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const unsigned power = *rc::gen::inRange(1u, 4u);
        const auto turns = powers(system, power);
        RC_ASSERT(turns.size() == power);
        const unsigned last = oracle::last_generation_within(written, 200, 8);
        for (unsigned n = 0; n <= last; ++n) {
            const D0L& turn = turns[n % power];
            Word word = oracle::rewritten(turn.axiom, turn.rules.images(), n / power);
            RC_ASSERT(oracle::text_of(*turn.alphabet, word) == oracle::rewritten(written, n));
        }
    }));
}

TEST_CASE("a power that would be too large is refused") {
    Budget budget;
    budget.letters = 1000;
    CHECK_THROWS_AS(powers(d0l("a", {{'a', "aa"}}), 20, budget), BoundReached);
    CHECK_THROWS_AS(powers(d0l("a", {{'a', "aa"}}), 0), Error);
}
