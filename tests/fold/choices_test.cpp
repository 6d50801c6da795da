#include "fold/choices.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>

#include "base/error.hpp"
#include "fold/lifts.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

namespace {

/// One-character words in shortlex order of their names.
std::vector<std::string> shortlex(const std::set<std::string>& words) {
    std::vector<std::string> sorted(words.begin(), words.end());
    std::stable_sort(sorted.begin(), sorted.end(), [](auto& u, auto& v) { return u.size() < v.size(); });
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
                std::erase_if(short_ones, [&](const std::string& word) { return word.size() > longest; });
                RC_ASSERT(texts(*system.alphabet, words_of_generation(system, n, longest)) == shortlex(short_ones));
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

TEST_CASE("the short words of a language with erasing contain all that longer words on the way give") {
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
    const OL doubling = ol("1", {{'1', "22"}, {'2', "33"}, {'3', "44"}, {'4', "55"}, {'5', "66"}, {'6', "77"}, {'7', "x"}, {'7', ""}});
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
    const auto ways = [&](std::uint64_t n) { return fold(system, n, Lift{Counts{}, [](Symbol) { return Integer(1); }}); };
    CHECK(ways(0) == 1);
    CHECK(ways(1) == 4);
    CHECK(ways(2) == 36);   // (x + x^2) at 2 is 6, squared
    CHECK(ways(3) == 1764);  // 6 + 36 = 42, squared
}

TEST_CASE("numbers below a bound are the same everywhere") {
    std::mt19937_64 one(1), huge(1), large(42);
    std::vector<std::uint64_t> found;
    for (int i = 0; i < 12; ++i) found.push_back(below(one, 6));
    CHECK(found == std::vector<std::uint64_t>{2, 0, 0, 0, 0, 3, 2, 3, 2, 4, 2, 5});
    // A quarter of the numbers of 64 bits are thrown away here.
    const std::uint64_t three_quarters = std::uint64_t{3} << 62;
    for (const std::uint64_t value : {8323445853463659930u, 6472927700900931384u, 2976530614050842697u, 8683844110200328628u})
        CHECK(below(huge, three_quarters) == value);
    for (const std::uint64_t value : {852258120406u, 577503494824u, 24467741450u})
        CHECK(below(large, 1'000'000'000'000) == value);
}

TEST_CASE("numbers below a bound are as likely as each other") {
    std::mt19937_64 generator(7);
    std::vector<int> seen(5);
    for (int i = 0; i < 100'000; ++i) ++seen[below(generator, 5)];
    // Five standard deviations of a binomial of 100000 draws at 1/5 are 632.
    for (const int count : seen) CHECK(std::abs(count - 20'000) < 632);
    for (int i = 0; i < 100; ++i) CHECK(below(generator, 1) == 0);
}

TEST_CASE("a random word is one of its generation's") {
    const bool holds = rc::check("member", [] {
        const auto written = *oracle::any_0l(2, true);
        const OL system = oracle::ol_of(written);
        std::mt19937_64 generator(*rc::gen::arbitrary<std::uint64_t>());
        for (unsigned n = 0; n <= 2; ++n)
            RC_ASSERT(oracle::words_of_generation(written, n).contains(
                oracle::text_of(*system.alphabet, random_word(system, n, generator))));
    });
    CHECK(holds);
}

TEST_CASE("random words are the same everywhere for the same seed") {
    const OL plant = ol("F", {{'F', "F[+F]F"}, {'F', "F[-F]F"}, {'F', "F"}});
    const OL erasing = ol("ab", {{'a', "ab"}, {'a', "b"}, {'a', ""}, {'b', "a"}, {'b', "ba"}});
    const auto word = [](const OL& system, std::uint64_t n, std::uint64_t seed) {
        std::mt19937_64 generator(seed);
        return oracle::text_of(*system.alphabet, random_word(system, n, generator));
    };
    CHECK(word(plant, 3, 0) == "F[-F]F[+F[-F[-F]F]F[+F]F]F[+F]F");
    CHECK(word(plant, 3, 1) == "F[+F]F[+F[+F]F]F[+F]F");
    CHECK(word(plant, 3, 2026) == "F[+F]F[+F]F");
    CHECK(word(erasing, 6, 0) == "abaab");
    CHECK(word(erasing, 6, 1) == "aab");
    CHECK(word(erasing, 6, 2026) == "ababab");
}

TEST_CASE("a random derivation ends early only where nothing can change any more") {
    std::mt19937_64 generator(1);
    CHECK(random_word(ol("c", {}), UINT64_MAX, generator) == Word{0});
    CHECK(random_word(ol("m", {{'m', ""}}), UINT64_MAX, generator).empty());
    // `a` stays with one of two choices: staying once does not mean staying for ever.
    CHECK(random_word(ol("a", {{'a', "a"}, {'a', "b"}}), 1000, generator) == Word{1});
}

TEST_CASE("a random word of more letters than allowed is refused, and a stop is heeded") {
    Budget budget;
    budget.letters = 8;
    std::mt19937_64 generator(1);
    const OL system = ol("F", {{'F', "FF"}});
    CHECK(random_word(system, 3, generator, budget).size() == 8);
    CHECK_THROWS_WITH_AS(random_word(system, 4, generator, budget),
                         "generation 4 has more than 8 letters, the bound set by --max-letters", BoundReached);
    std::atomic<bool> stop = true;
    budget.stop = &stop;
    CHECK_THROWS_AS(random_word(system, 1, generator, budget), Interrupted);
}
