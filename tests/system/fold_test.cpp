#include "system/system.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "exact/exact.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

namespace {

std::vector<Integer> numbers(const std::vector<long>& values) {
    return {values.begin(), values.end()};
}

/// How often each letter of the alphabet occurs.
std::vector<Integer> occurrences(const Alphabet& alphabet, const std::string& word) {
    std::vector<long> counts(alphabet.size(), 0);
    for (const char letter : word) ++counts[*alphabet.find(std::string(1, letter))];
    return numbers(counts);
}

}  // namespace

TEST_CASE("a fold is what the word spelled out would give") {
    const bool holds = rc::check("words, lengths, spellings, counts", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const Alphabet& alphabet = *system.alphabet;
        const unsigned last = oracle::last_generation_within(written, 3000, 9);
        for (unsigned n = 0; n <= last; ++n) {
            const std::string word = oracle::rewritten(written, n);
            RC_ASSERT(oracle::text_of(alphabet, fold(system, n, word_lift())) == word);
            RC_ASSERT(fold(system, n, length_lift()) == word.size());
            RC_ASSERT(fold(system, n, spelling_lift(alphabet)).text == word);
            const auto parikh = fold(system, n, Lift{Vectors{alphabet.size()}, [&](Symbol a) {
                                                         auto unit = Vectors{alphabet.size()}.one();
                                                         unit[a] = 1;
                                                         return unit;
                                                     }});
            RC_ASSERT(parikh == occurrences(alphabet, word));
            for (Symbol a = 0; a < alphabet.size(); ++a)
                RC_ASSERT(fold(system, n, count_lift(a)).front() ==
                          std::count(word.begin(), word.end(), alphabet.name(a)[0]));
        }
    });
    CHECK(holds);
}

TEST_CASE("brackets count as two letters, as the letters they are, or not at all") {
    const bool holds = rc::check("bracketed systems", [] {
        const auto written = *oracle::any_bracketed();
        const D0L system = oracle::d0l_of(written);
        const unsigned n = oracle::last_generation_within(written, 3000, 5);
        const std::string word = oracle::rewritten(written, n);
        const auto brackets = std::count(word.begin(), word.end(), '[');
        RC_ASSERT(fold(system, n, length_lift()) == word.size());
        RC_ASSERT(oracle::text_of(*system.alphabet, fold(system, n, word_lift())) == word);
        // A lift that lets brackets count nothing: Branching sees pairs, not letters.
        const auto inner =
            fold(system, n, Lift{Sums{0}, [&](Symbol a) {
                                     const std::string& name = system.alphabet->name(a);
                                     return Integer(name == "[" || name == "]" ? 0 : 1);
                                 }});
        RC_ASSERT(inner == static_cast<long>(word.size()) - 2 * brackets);
        if (const auto open = system.alphabet->find("["))
            RC_ASSERT(fold(system, n, count_lift(*open)).front() == brackets);
    });
    CHECK(holds);
}

TEST_CASE("bracket balance is folded where brackets do not match") {
    const auto balance_of = [](const D0L& system, std::uint64_t n) {
        return fold(system, n, Lift{BracketBalance{}, [&](Symbol a) {
                                        const std::string& name = system.alphabet->name(a);
                                        return name == "["   ? BracketBalance::value_type{1, 0}
                                               : name == "]" ? BracketBalance::value_type{-1, -1}
                                                             : BracketBalance::value_type{};
                                    }});
    };
    const bool holds = rc::check("any brackets", [&] {
        const oracle::WrittenSystem written{
            *oracle::any_word("ab[]", 4),
            {{'a', {*oracle::any_word("ab[]", 4)}}, {'b', {*oracle::any_word("a[]", 3)}}}};
        const D0L system = oracle::d0l_of(written);
        for (unsigned n = 0; n <= 4; ++n) {
            long depth = 0, lowest = 0;
            for (const char letter : oracle::rewritten(written, n)) {
                depth += letter == '[' ? 1 : letter == ']' ? -1 : 0;
                lowest = std::min(lowest, depth);
            }
            RC_ASSERT((balance_of(system, n) == BracketBalance::value_type{depth, lowest}));
        }
    });
    CHECK(holds);
}

TEST_CASE("row k of a tower sends a letter to the image of what it becomes in k steps") {
    const bool holds = rc::check("towers", [] {
        auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const unsigned n = std::min(5u, oracle::last_generation_within(written, 500, 5));
        const auto rows = tower(system, n, word_lift());
        RC_ASSERT(rows.size() == n + 1);
        for (unsigned k = 0; k <= n; ++k)
            for (const Symbol a : system.letters) {
                written.axiom = system.alphabet->name(a);
                RC_ASSERT(oracle::text_of(*system.alphabet, rows[k].images[a]) ==
                          oracle::rewritten(written, k));
            }
    });
    CHECK(holds);
}

TEST_CASE("letters that no word reaches cost nothing") {
    const D0L system = d0l("A", {{'A', "A"}, {'B', "BB"}});
    CHECK(fold(system, 10'000, length_lift()) == 1);
    CHECK(fold(system, 1'000, spelling_lift(*system.alphabet)).text == "A");
}

TEST_CASE("lengths of far generations") {
    CHECK(fold(d0l("F", {{'F', "F+F--F+F"}}), 100, count_lift(0)).front() ==
          power(Integer(4), 100));
    CHECK(fold(d0l("F", {{'F', "FF"}}), 5000, length_lift()) == power(Integer(2), 5000));
    CHECK(fold(d0l("a", {{'a', "ab"}}), 5000, length_lift()) == 5001);
    CHECK(fold(d0l("", {{'a', "ab"}}), 5000, length_lift()) == 0);
}

TEST_CASE("a fold that is told to stop stops") {
    std::atomic<bool> stop = true;
    Budget budget;
    budget.stop = &stop;
    CHECK_THROWS_AS(fold(d0l("a", {{'a', "aa"}}), 10, length_lift(), budget), Interrupted);
    CHECK_THROWS_AS(tower(d0l("a", {{'a', "aa"}}), 10, length_lift(), budget), Interrupted);
}

TEST_CASE(
    "a system that no longer changes is folded at once, however many generations are asked for") {
    const std::uint64_t far = UINT64_MAX;
    CHECK(fold(d0l("aXc", {{'a', "b"}, {'X', ""}, {'b', "b"}}), far, length_lift()) == 2);
    CHECK(fold(d0l("a", {{'a', ""}}), far, word_lift()).empty());
}
