#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exact/exact.hpp"
#include "growth/expanded.hpp"
#include "growth/growth.hpp"

using namespace algae;

namespace {

std::vector<std::uint64_t> counts(const D0L& system, std::size_t length) {
    return factor_complexity(system, length);
}
using Counts = std::vector<std::uint64_t>;

std::set<std::string> texts(const D0L& system, const FactorSet& set) {
    std::set<std::string> found;
    for (const Word& word : set.words)
        if (word.size() == set.length) found.insert(oracle::text_of(*system.alphabet, word));
    return found;
}

}  // namespace

TEST_CASE("the Fibonacci word has k + 1 factors of k letters") {
    const auto complexity = counts(d0l("a", {{'a', "ab"}, {'b', "a"}}), 200);
    REQUIRE(complexity.size() == 201);
    for (std::size_t k = 0; k <= 200; ++k) CHECK(complexity[k] == k + 1);
}

TEST_CASE("the factors of well-known words") {
    CHECK(counts(d0l("a", {{'a', "ab"}, {'b', "ba"}}), 16) ==
          Counts{1, 2, 4, 6, 10, 12, 16, 20, 22, 24, 28, 32, 36, 40, 42, 44, 46});
    const auto tribonacci = counts(d0l("a", {{'a', "ab"}, {'b', "ac"}, {'c', "a"}}), 50);
    for (std::size_t k = 1; k <= 50; ++k) CHECK(tribonacci[k] == 2 * k + 1);
    const auto chacon = counts(d0l("a", {{'a', "aaba"}, {'b', "b"}}), 60);
    for (std::size_t k = 2; k <= 60; ++k) CHECK(chacon[k] == 2 * k - 1);
}

TEST_CASE("a finite language has no long factors, and the shorter words count") {
    CHECK(counts(d0l("a", {{'a', "b"}, {'b', "c"}, {'c', ""}}), 3) == Counts{1, 3, 0, 0});
    CHECK(counts(d0l("a", {{'a', "ab"}, {'b', "c"}, {'c', ""}}), 4) == Counts{1, 3, 2, 1, 0});
    CHECK(counts(d0l("", {{'a', "ab"}}), 2) == Counts{1, 0, 0});
}

TEST_CASE("a long run of letters that vanish is no obstacle") {
    // 8^12 letters m stand between two letters a, twelve steps before they are gone
    std::vector<std::pair<char, std::string>> rules{{'a', "aba"}};
    for (char c = 'b'; c < 'm'; ++c)
        rules.emplace_back(c, std::string(8, static_cast<char>(c + 1)));
    rules.emplace_back('m', "");
    const auto complexity = counts(d0l("a", rules), 10);
    CHECK(complexity[1] == 13);
    CHECK(complexity[2] > 13);
}

TEST_CASE("the factors of random systems are those seen in their words") {
    CHECK(rc::check([] {
        const auto written = *rc::gen::oneOf(any_growing_d0l(), oracle::any_d0l());
        const auto length = *rc::gen::inRange<std::size_t>(1, 6);
        const D0L system = oracle::d0l_of(written);
        const auto words = expanded(written, 30'000, 60);
        const auto exact = texts(system, factors(system, length));
        const auto seen = factors_of(words, length);
        RC_ASSERT(std::includes(exact.begin(), exact.end(), seen.begin(), seen.end()));
        // A factor may come late: then longer words have it.
        RC_ASSERT(exact == seen || exact == factors_of(expanded(written, 3'000'000, 200), length));
        const auto complexity = counts(system, length);
        for (std::size_t k = 0; k <= length; ++k)
            RC_ASSERT(complexity[k] == texts(system, factors(system, k)).size());
    }));
}

TEST_CASE("words that begin one another are beginnings of one infinite word") {
    CHECK(generates_infinite_word(d0l("ab", {{'a', "ab"}, {'b', "b"}})));
    CHECK(!generates_infinite_word(d0l("b", {{'a', "ab"}, {'b', "a"}})));
    CHECK(!generates_infinite_word(d0l("a", {{'a', "ab"}, {'b', ""}})));
}

TEST_CASE("a set of factors that takes too much memory is refused") {
    Budget budget;
    budget.memory = 100'000;
    CHECK_THROWS_AS(factors(d0l("a", {{'a', "ab"}, {'b', "bc"}, {'c', "c"}}), 200, budget),
                    BoundReached);
}
