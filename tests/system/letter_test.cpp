#include "system/system.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <thread>

#include "exact/exact.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

namespace {

const D0L fibonacci = d0l("b", {{'a', "ab"}, {'b', "a"}});

std::string letters(const D0L& system, std::uint64_t n, const Integer& at, std::uint64_t count) {
    return oracle::text_of(*system.alphabet, letters_at(system, n, at, count));
}

/// The letter at a position of the infinite Fibonacci word abaab..., by arithmetic: it is b exactly
/// if the position, written as a sum of Fibonacci numbers 1, 2, 3, 5, ... no two of them adjacent
/// (Zeckendorf), has the 1 in it. (Lothaire 2002, 2.1 and exercise 2.1.2.)
char fibonacci_letter(Integer position) {
    std::vector<Integer> numbers{1, 2};
    while (numbers.back() <= position)
        numbers.push_back(numbers[numbers.size() - 1] + numbers[numbers.size() - 2]);
    bool one = false;
    for (std::size_t i = numbers.size(); i-- > 0;)
        if (numbers[i] <= position) {
            position -= numbers[i];
            one = one || i == 0;
        }
    return one ? 'b' : 'a';
}

}  // namespace

TEST_CASE("letters from any position, any number of them, are a slice of the word") {
    const bool holds = rc::check("slices", [] {
        const auto written = *oracle::any_d0l();
        const D0L system = oracle::d0l_of(written);
        const unsigned n =
            *rc::gen::inRange(0u, oracle::last_generation_within(written, 40, 7) + 1);
        const std::string word = oracle::rewritten(written, n);
        for (std::size_t at = 0; at < word.size(); ++at)
            for (std::size_t count = 0; count <= word.size() - at + 1; ++count)
                RC_ASSERT(letters(system, n, at, count) == word.substr(at, count));
        for (const std::size_t past : {word.size(), word.size() + 7}) {
            std::string message;
            try {
                letters_at(system, n, past, 1);
            } catch (const Error& error) {
                message = error.what();
            }
            RC_ASSERT(message == "position " + std::to_string(past) +
                                     " is past the end: generation " + std::to_string(n) + " has " +
                                     std::to_string(word.size()) + " letters");
        }
    });
    CHECK(holds);
}

TEST_CASE("a position past the end says how many letters there are") {
    CHECK_THROWS_WITH_AS(letters_at(fibonacci, 10, 89, 1),
                         "position 89 is past the end: generation 10 has 89 letters", Error);
    CHECK_THROWS_WITH_AS(letters_at(d0l("", {}), 10, 0, 1),
                         "position 0 is past the end: generation 10 has 0 letters", Error);
    CHECK_THROWS_WITH_AS(
        letters_at(fibonacci, 300, power(Integer(10), 100), 1),
        ("position 1" + std::string(100, '0') + " is past the end: generation 300 has " +
         "359579325206583560961765665172189099052367214309267232255589801 letters")
            .c_str(),
        Error);
}

TEST_CASE("a negative position is an error") {
    CHECK_THROWS_WITH_AS(letters_at(fibonacci, 10, -1, 1),
                         "position -1 is before the beginning: positions count from 0", Error);
}

TEST_CASE("the Fibonacci word is told by the Zeckendorf representation, at positions of any size") {
    // The arithmetic agrees with rewriting where that can go.
    const std::string word = oracle::rewritten({"b", {{'a', {"ab"}}, {'b', {"a"}}}}, 15);
    for (std::size_t at = 0; at < word.size(); ++at) REQUIRE(fibonacci_letter(at) == word[at]);

    const bool holds = rc::check("100-digit positions", [] {
        Integer at = 1 + *rc::gen::inRange(0, 9);
        for (int digit = 0; digit < 99; ++digit) at = at * 10 + *rc::gen::inRange(0, 10);
        std::string expected;
        for (int i = 0; i < 20; ++i) expected += fibonacci_letter(at + i);
        // Words of later generations begin with those of earlier ones.
        RC_ASSERT(letters(fibonacci, 600, at, 20) == expected);
        RC_ASSERT(letters(fibonacci, 601, at, 20) == expected);
    });
    CHECK(holds);
}

TEST_CASE("generation 1000000 is answered") {
    const Integer at = power(Integer(10), 100);
    std::string expected;
    for (int i = 0; i < 30; ++i) expected += fibonacci_letter(at + i);
    CHECK(letters(fibonacci, 1'000'000, at, 30) == expected);
    // A word that grows by one letter a generation: every row of lengths is different.
    CHECK(letters(d0l("b", {{'b', "ab"}}), 1'000'000, 999'999, 2) == "ab");
    CHECK(letters(d0l("b", {{'b', "ba"}}), 1'000'000, 999'999, 2) == "aa");
    CHECK_THROWS_WITH_AS(letters_at(d0l("b", {{'b', "ab"}}), 1'000'000, 1'000'001, 1),
                         "position 1000001 is past the end: generation 1000000 has 1000001 letters",
                         Error);
}

TEST_CASE("generations near 2^64 are answered where the letters stay") {
    CHECK(letters(d0l("cc", {{'c', "c"}}), UINT64_MAX, 1, 8) == "c");
    CHECK(letters(d0l("ac", {{'a', ""}}), UINT64_MAX, 0, 8) == "c");
}

TEST_CASE("a look-up that is told to stop stops, at generations of any size") {
    std::atomic<bool> stop = true;
    Budget budget;
    budget.stop = &stop;
    CHECK_THROWS_AS(
        letters_at(d0l("b", {{'b', "ab"}}), UINT64_MAX, power(Integer(10), 30), 1, budget),
        Interrupted);
    budget.stop = nullptr;
    budget.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(20);
    CHECK_THROWS_AS(
        letters_at(d0l("b", {{'b', "ab"}}), UINT64_MAX, power(Integer(10), 30), 1, budget),
        BoundReached);
    CHECK_THROWS_AS(letters_at(d0l("p", {{'p', "q"}, {'q', "p"}}), UINT64_MAX, 0, 1, budget),
                    BoundReached);
}

TEST_CASE("a table of lengths that takes more than the memory allowed is refused") {
    Budget budget;
    budget.memory = 1 << 10;
    CHECK_THROWS_WITH_AS(letters_at(d0l("b", {{'b', "ab"}}), 1'000'000, 999'999, 1, budget),
                         "the table of lengths would take more than the 0 MiB allowed",
                         BoundReached);
}

TEST_CASE("the way down takes memory for the letters asked for, not for the generations") {
    Budget budget;
    budget.memory = 1 << 19;
    CHECK(letters_at(fibonacci, 3'000'001, 0, 8, budget) == letters_at(fibonacci, 21, 0, 8));
    CHECK(letters_at(fibonacci, 3'000'000, 5, 3000, budget) == letters_at(fibonacci, 30, 5, 3000));
}

TEST_CASE("more letters than allowed are refused, as many are not") {
    Budget budget;
    budget.letters = 5;
    CHECK(letters_at(fibonacci, 10, 3, 5, budget).size() == 5);
    CHECK_THROWS_WITH_AS(letters_at(fibonacci, 10, 3, 6, budget),
                         "more than 5 letters asked for, the bound set", BoundReached);
}
