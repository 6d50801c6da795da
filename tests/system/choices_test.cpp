#include "system/system.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "exact/exact.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

namespace {

/// One-character words in shortlex order of their names.
std::vector<std::string> shortlex(const std::set<std::string>& words) {
    std::vector<std::string> sorted(words.begin(), words.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](auto& u, auto& v) { return u.size() < v.size(); });
    return sorted;
}

std::vector<std::string> texts(const Alphabet& alphabet, const std::vector<Word>& words) {
    std::vector<std::string> all;
    for (const Word& word : words) all.push_back(oracle::text_of(alphabet, word));
    return all;
}

/// Integers as a semiring: how many derivations there are.
struct Counts {
    using value_type = Integer;
    Integer zero() const { return 0; }
    Integer one() const { return 1; }
    void add(Integer& left, const Integer& right) const { left += right; }
    void append(Integer& left, const Integer& right) const { left *= right; }
};

}  // namespace

TEST_CASE("the words of a generation are those that trying every choice gives, in shortlex order") {
    const bool holds = rc::check("words_of_generation", [] {
        const auto written = *oracle::any_0l(2, true);
        const OL system = oracle::ol_of(written);
        std::set<std::string> words{written.axiom};
        for (unsigned n = 0; n <= 3; ++n) {
            words = oracle::words_of_generation(written, n);
            RC_ASSERT(texts(*system.alphabet, words_of_generation(system, n)) == shortlex(words));
            for (const std::size_t longest : {0u, 1u, 3u}) {
                std::set<std::string> short_ones = words;
                std::erase_if(short_ones,
                              [&](const std::string& word) { return word.size() > longest; });
                RC_ASSERT(texts(*system.alphabet, words_of_generation(system, n, longest)) ==
                          shortlex(short_ones));
            }
            if (words.size() > 100) break;
        }
    });
    CHECK(holds);
}

TEST_CASE("the short words of a language without erasing are found by going through short words") {
    const bool holds = rc::check("propagating", [] {
        const auto written = *oracle::any_0l(2, false);
        const OL system = oracle::ol_of(written);
        for (const std::size_t longest : {0u, 1u, 2u, 4u})
            RC_ASSERT(texts(*system.alphabet, words_up_to(system, longest)) ==
                      shortlex(oracle::words_up_to(written, longest, 4)));
    });
    CHECK(holds);
}

TEST_CASE(
    "the short words of a language with erasing contain all that longer words on the way give") {
    const bool holds = rc::check("erasing", [] {
        const auto written = *oracle::any_0l(2, true);
        const OL system = oracle::ol_of(written);
        const auto found = texts(*system.alphabet, words_up_to(system, 2));
        for (const std::string& word : oracle::words_up_to(written, 2, 6))
            RC_ASSERT(std::find(found.begin(), found.end(), word) != found.end());
        RC_ASSERT(std::is_sorted(found.begin(), found.end(), [](auto& u, auto& v) {
            return u.size() != v.size() ? u.size() < v.size() : u < v;
        }));
    });
    CHECK(holds);
}

TEST_CASE("short words that come only from longer ones are found, and only those") {
    const auto up_to = [](const OL& system, std::size_t longest) {
        return texts(*system.alphabet, words_up_to(system, longest));
    };
    const OL through_three = ol("a", {{'a', "bbb"}, {'b', "c"}, {'b', ""}});
    CHECK(up_to(through_three, 1) == std::vector<std::string>{"", "a", "c"});
    CHECK(up_to(through_three, 3) == std::vector<std::string>{"", "a", "c", "cc", "bbb", "ccc"});
    // From 64 letters down to one, in the seventh generation.
    const OL doubling = ol("1", {{'1', "22"},
                                 {'2', "33"},
                                 {'3', "44"},
                                 {'4', "55"},
                                 {'5', "66"},
                                 {'6', "77"},
                                 {'7', "x"},
                                 {'7', ""}});
    CHECK(up_to(doubling, 1) == std::vector<std::string>{"", "1", "x"});
    CHECK(up_to(ol("", {{'a', "aa"}}), 3) == std::vector<std::string>{""});
    CHECK(up_to(ol("a", {{'a', "b"}, {'b', "a"}}), 1) == std::vector<std::string>{"a", "b"});
    CHECK(up_to(ol("aa", {{'a', "aa"}}), 1).empty());
}

TEST_CASE("a language whose generations repeat only after long is complete") {
    // Cycles of 2, 3, 5 and 7 letters: the words repeat after 210 generations.
    std::vector<std::pair<char, std::string>> rules;
    const std::string cycles[] = {"ab", "cde", "fghij", "klmnopq"};
    for (const std::string& cycle : cycles)
        for (std::size_t i = 0; i < cycle.size(); ++i)
            rules.emplace_back(cycle[i], std::string(1, cycle[(i + 1) % cycle.size()]));
    CHECK(words_up_to(ol("acfk", rules), 4).size() == 210);
}

TEST_CASE("looking for short words takes no more memory for a long cycle than for a short one") {
    std::vector<std::pair<char, std::string>> rules;
    for (const std::string cycle : {"ab", "cde", "fghij", "klmnopq", "ABCDEFGHIJK"})
        for (std::size_t i = 0; i < cycle.size(); ++i)
            rules.emplace_back(cycle[i], std::string(1, cycle[(i + 1) % cycle.size()]));
    Budget budget;
    budget.memory = 1 << 19;
    CHECK(words_up_to(ol("acfkA", rules), 5, budget).size() == 2310);
}

TEST_CASE("too many words for the memory allowed are refused") {
    Budget budget;
    budget.memory = 1 << 20;
    const OL system = ol("aaaaaaaa", {{'a', "ab"}, {'a', "ba"}, {'a', "c"}});
    CHECK_THROWS_AS(words_of_generation(system, 3, std::nullopt, budget), BoundReached);
    CHECK_THROWS_AS(words_up_to(system, 20, budget), BoundReached);
}

TEST_CASE("the fold of an 0L system counts derivations in a semiring of numbers") {
    // Every a has two choices: 2^k words for k letters, generation after generation.
    const OL system = ol("aa", {{'a', "a"}, {'a', "aa"}});
    const auto ways = [&](std::uint64_t n) {
        return fold(system, n, Lift{Counts{}, [](Symbol) { return Integer(1); }});
    };
    CHECK(ways(0) == 1);
    CHECK(ways(1) == 4);
    CHECK(ways(2) == 36);    // (x + x^2) at 2 is 6, squared
    CHECK(ways(3) == 1764);  // 6 + 36 = 42, squared
}
