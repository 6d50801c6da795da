#include "system/detail/interaction.hpp"
#include "places.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"

using namespace algae;

namespace {

IL system_of(const std::string& text) { return *as_il(read_lsystem(text, "written.lsys")); }

std::string file_text(const std::string& name) {
    std::ifstream in(source_folder() + "/systems/" + name);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string word(const IL& system, std::uint64_t n) {
    return spell(*system.alphabet, derive(system, n));
}

}  // namespace

TEST_CASE("a signal runs along a word and is lost at its end") {
    const IL signal = system_of("axiom baaa; b < a -> b; b -> a");
    CHECK(word(signal, 1) == "abaa");
    CHECK(word(signal, 3) == "aaab");
    CHECK(word(signal, 4) == "aaaa");
    CHECK(word(signal, 9) == "aaaa");
}

TEST_CASE("more context beats less, then the first in the file") {
    CHECK(word(system_of("axiom xay; a -> p; x < a -> q; x < a > y -> r"), 1) == "xry");
    CHECK(word(system_of("axiom xay; a > y -> q; x < a -> p"), 1) == "xqy");
    CHECK(word(system_of("axiom bcag; bc < a -> p; c < a > g -> q; a > g -> r"), 1) == "bcpg");
}

TEST_CASE("contexts are words of any length, and nothing matches beyond the ends") {
    CHECK(word(system_of("axiom abcabc; ab < c > ab -> x; bc < a > bc -> y"), 1) == "abxybc");
    CHECK(word(system_of("axiom aa; a < a -> b"), 1) == "ab");
}

TEST_CASE("ignored letters are not seen") {
    CHECK(word(system_of("axiom a+-b; a < b -> c; ignore + -"), 1) == "a+-c");
    CHECK(word(system_of("axiom a+-b; a < b -> c"), 1) == "a+-b");
}

TEST_CASE("what is no deterministic IL system says why") {
    const auto reason = [](const std::string& text) {
        return as_dil(read_lsystem(text, "w.lsys")).reason();
    };
    CHECK(reason("axiom a; b < a -> x; b < a -> y") ==
          "not a deterministic IL system: a has two rules with the same contexts");
    CHECK(reason("axiom A(1); A(x) -> A(x+1)") ==
          "not a deterministic IL system: the axiom has parameters");
    CHECK(as_il(read_lsystem("axiom A(1); A(x) -> A(x+1)", "w.lsys")).reason() ==
          "not an IL system: the axiom has parameters");
}

TEST_CASE("rules with the same contexts are a choice") {
    const IL system = system_of("axiom ab; a > b -> aa; b -> b; a > b -> b; a > b -> aa");
    CHECK(!is_deterministic(system));
    CHECK(is_propagating(system));
    CHECK_THROWS_WITH_AS(derive(system, 1),
                         "written.lsys has a choice between rules with the same contexts, so no "
                         "generation is one word",
                         Error);
    CHECK_THROWS_AS(next_word(system, system.axiom), Error);
    const auto words = [&](const std::vector<Word>& all) {
        std::string text;
        for (const Word& each : all) text += spell(*system.alphabet, each) + ' ';
        return text;
    };
    CHECK(words(words_of_generation(system, 1)) == "bb aab ");
    CHECK(words(words_of_generation(system, 2)) == "bb abb aaab ");
    CHECK(words(words_of_generation(system, 2, 3)) == "bb abb ");
    CHECK(words(words_up_to(system, 3)) == "ab bb aab abb bbb ");
    ContextStep step(system);
    CHECK(step.gives({0, 1}, {1, 1}));
    CHECK(!step.gives({0, 1}, {0, 1}));
    CHECK(words(step.next({0, 1}, 2)) == "bb ");
    // Longer contexts still come first, and choose among themselves.
    const IL longer =
        system_of("axiom cab; a > b -> x; c < a > b -> y; c < a > b -> z; a > b -> b");
    CHECK(words_of_generation(longer, 1).size() == 2);
}

TEST_CASE("all words of a system with context that erases are found where the language is finite") {
    const IL finite = system_of("axiom aab; a > b -> ; a > b -> a");
    CHECK(words_up_to(finite, 2).size() == 2);
    Budget small;
    small.memory = 1 << 20;
    CHECK_THROWS_AS(words_up_to(system_of("axiom ab; a > b -> aa; b -> ; b -> b"), 2, small),
                    BoundReached);
}

TEST_CASE("cellular automata are systems with interactions") {
    // Rule 110 with cells that never change beyond the ends, against bits.
    CHECK(rc::check([] {
        const auto cells = *rc::gen::container<std::vector<int>>(20, rc::gen::inRange(0, 2));
        std::string axiom, rules;
        for (const int cell : cells) axiom += cell ? '1' : '0';
        for (int k = 0; k < 8; ++k)
            rules += std::string("; ") + char('0' + k / 4) + " < " + char('0' + k / 2 % 2) + " > " +
                     char('0' + k % 2) + " -> " + char('0' + (110 >> k & 1));
        const IL automaton = system_of("axiom " + axiom + rules);
        std::vector<int> now = cells;
        for (int step = 0; step < 10; ++step) {
            std::vector<int> next = now;
            for (std::size_t i = 1; i + 1 < now.size(); ++i)
                next[i] = 110 >> (4 * now[i - 1] + 2 * now[i] + now[i + 1]) & 1;
            now = next;
        }
        std::string expected;
        for (const int cell : now) expected += cell ? '1' : '0';
        RC_ASSERT(word(automaton, 10) == expected);
    }));
}

TEST_CASE("ten thousand lengths that grow like the square root") {
    const auto lengths = derived_lengths(system_of(file_text("square-root-growth.lsys")), 10'000);
    // The signal as a number: its place among the cells, and which way it goes.
    std::size_t cells = 1, place = 0;
    bool right = true;
    for (std::size_t n = 0; n < lengths.size(); ++n) {
        REQUIRE(lengths[n] == cells + 2);
        if (right && place + 1 == cells) {
            place = cells++;
            right = false;
        } else if (right) {
            ++place;
        } else if (place == 0) {
            ++cells;
            right = true;
        } else {
            --place;
        }
    }
    CHECK(lengths.back() == 143);
}

TEST_CASE("ten thousand lengths that grow like the logarithm") {
    const auto lengths = derived_lengths(system_of(file_text("logarithmic-growth.lsys")), 10'000);
    // Digit k gets its carries from digit k - 1 one step later: it is made at the step at which
    // digit k - 1 hands on its first carry.
    std::vector<std::size_t> made{0};
    while (made.back() <= lengths.size()) {
        const std::size_t k = made.size();
        // Digit j counts carries, one for every two of digit j - 1, and hands on one a step later;
        // a new digit is made as 1, having counted the carry that made it.
        std::size_t first = 0;
        if (k == 1)
            first = 3;  // 0 -> 1 -> c, and e sees the c
        else
            first = made[k - 1] + (std::size_t{1} << (k - 1)) + 1;
        made.push_back(first);
    }
    for (std::size_t n = 0; n < lengths.size(); ++n) {
        std::size_t digits = 0;
        while (digits < made.size() && made[digits] <= n) ++digits;
        REQUIRE(lengths[n] == digits + 2);
    }
    CHECK(lengths.back() == 16);
}

TEST_CASE("a word that is too long is refused with its generation") {
    Budget budget;
    budget.letters = 100;
    CHECK_THROWS_WITH_AS(derive(system_of("axiom ab; a -> aa; a < b -> bb"), 50, budget),
                         "generation 7 has more than 100 letters, the bound set", BoundReached);
}
