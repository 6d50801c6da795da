#include "language/language.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <bit>

#include "exact/exact.hpp"
#include "oracle/random_tables.hpp"

using namespace algae;

namespace {

using Reason = Membership::Reason;

Word word_of(const ET0L& system, const std::string& text) {
    Word word;
    for (const char letter : text)
        word.push_back(system.alphabet->find(std::string(1, letter))
                           .value_or(static_cast<Symbol>(system.alphabet->size())));
    return word;
}

/// All words over a, b, c of at most `longest` letters.
std::vector<std::string> all_texts(std::size_t longest) {
    std::vector<std::string> found{""};
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i].size() < longest)
            for (const char letter : std::string("abc")) found.push_back(found[i] + letter);
    return found;
}

/// The member has a derivation of the word by nothing but the tables.
bool is_derived(const ET0L& system, const Word& word, const Membership& found) {
    const Derivation how = derivation(system, word, found);
    return is_derivation(system, how) && how.words.back() == word &&
           how.choices.size() == found.step;
}

}  // namespace

TEST_CASE("membership in ET0L languages agrees with trying every sequence of tables") {
    for (const bool erasing : {false, true}) {
        std::size_t members = 0, tried = 0;
        const bool holds = rc::check("every word of up to 3 letters", [&] {
            const auto written = *oracle::any_tables(3, erasing, {"", "a", "ab", "bc"});
            const auto listed = oracle::short_words(written, 3, 300);
            if (!listed) return;
            ++tried;
            const ET0L system = oracle::et0l_of(written);
            for (const std::string& text : all_texts(3)) {
                const Word word = word_of(system, text);
                const Membership found = membership(system, word);
                RC_ASSERT(found.member == listed->contains(text));
                RC_ASSERT(found.member == (found.reason == Reason::derived));
                if (found.member) RC_ASSERT(is_derived(system, word, found));
                members += found.member;
            }
        });
        CHECK(holds);
        CHECK(tried > 50);
        CHECK(members > 100);
    }
}

TEST_CASE("a member is derived in the first generation that has it") {
    const bool holds = rc::check("generations 0 to 3", [] {
        const auto written = *oracle::any_tables(2, true, {"", "ab", "c"});
        const ET0L system = oracle::et0l_of(written);
        std::set<std::string> before;
        for (unsigned n = 0; n <= 3; ++n) {
            const auto words = oracle::words_of_generation(written, n);
            if (words.size() > 200) break;
            for (const std::string& text : words)
                if (written.is_terminal_word(text) && before.insert(text).second) {
                    const Membership found = membership(system, word_of(system, text));
                    RC_ASSERT(found.member);
                    RC_ASSERT(found.step == n);
                }
        }
    });
    CHECK(holds);
}

TEST_CASE("one table without terminals is the 0L system") {
    const bool holds = rc::check("0L", [] {
        const auto written = *oracle::any_tables(1, true, {""});
        const ET0L system = oracle::et0l_of(written);
        for (const std::string& text : all_texts(3)) {
            const Word word = word_of(system, text);
            const Membership one = membership(system, word),
                             other = membership(without_terminals(system), word);
            RC_ASSERT(one.member == other.member);
            RC_ASSERT(one.step == other.step);
        }
    });
    CHECK(holds);
}

TEST_CASE("a^n b^n c^n is E0L: synchronised letters") {
    // Letters with a bar, here capital, become terminals all at once; terminals become N, which
    // never ends.
    const ET0L system = et0l("ABC",
                             {{{'A', "AX"},
                               {'B', "BY"},
                               {'C', "CZ"},
                               {'X', "X"},
                               {'Y', "Y"},
                               {'Z', "Z"},
                               {'A', "a"},
                               {'B', "b"},
                               {'C', "c"},
                               {'X', "a"},
                               {'Y', "b"},
                               {'Z', "c"},
                               {'a', "N"},
                               {'b', "N"},
                               {'c', "N"},
                               {'N', "N"}}},
                             "abc");
    for (const std::string text : {"abc", "aabbcc", "aaabbbccc"}) {
        const Word word = word_of(system, text);
        const Membership found = membership(system, word);
        CHECK(found.member);
        CHECK(found.step == text.size() / 3);
        CHECK(is_derived(system, word, found));
    }
    for (const std::string text : {"", "aabbc", "abcabc", "aabbbccc"})
        CHECK_FALSE(membership(system, word_of(system, text)).member);
    const Membership capital = membership(system, word_of(system, "aBc"));
    CHECK(capital.reason == Reason::nonterminal);
    CHECK(capital.position == 1);
    CHECK(membership(system, word_of(system, "abd")).reason == Reason::foreign);
}

TEST_CASE("powers of two times powers of three by two tables") {
    const ET0L system = et0l("a", {{{'a', "aa"}}, {{'a', "aaa"}}});
    for (std::size_t length = 0; length <= 30; ++length) {
        std::size_t rest = length;
        std::uint64_t steps = 0;
        for (const std::size_t factor : {2u, 3u})
            for (; rest > 0 && rest % factor == 0; rest /= factor) ++steps;
        const Word word(length, 0);
        const Membership found = membership(system, word);
        CHECK(found.member == (rest == 1));
        if (found.member) CHECK(found.step == steps);
        if (found.member) CHECK(is_derived(system, word, found));
        if (!found.member) CHECK(found.reason == Reason::exhausted);
        // Powers of two come last; after them every word is too long, as powers of three are before.
        if (!found.member) CHECK(found.step == std::max<std::size_t>(1, std::bit_width(length)));
        if (!found.member) CHECK(found.states > 0);
    }
}

TEST_CASE("a derivation that was tampered with is none, and there is none of what is no member") {
    const ET0L system =
        et0l("ab", {{{'a', "a"}, {'a', "aa"}, {'b', "b"}, {'b', ""}}, {{'a', "b"}, {'b', "a"}}});
    const Word word = word_of(system, "bbb");
    const Membership found = membership(system, word);
    REQUIRE(found.member);
    const Derivation good = derivation(system, word, found);
    REQUIRE(is_derivation(system, good));
    REQUIRE(good.tables.size() == found.step);
    for (std::size_t t = 0; t < good.tables.size(); ++t) {
        Derivation other = good;
        other.tables[t] ^= 1;
        CHECK_FALSE(is_derivation(system, other));
        other.tables[t] = 2;
        CHECK_FALSE(is_derivation(system, other));
    }
    Derivation other = good;
    other.tables.pop_back();
    CHECK_FALSE(is_derivation(system, other));
    CHECK_FALSE(is_derivation(system, Derivation{}));
    CHECK_THROWS_WITH_AS(derivation(system, {}, Membership{}), "the word is not in the language",
                         Error);
    CHECK_THROWS_WITH_AS(without_terminals(system), "the system has 2 tables", Error);
}

TEST_CASE("what takes more memory than allowed stays undecided") {
    Budget budget;
    budget.memory = 3000;
    const ET0L system = et0l("abc", {{{'a', "ab"}, {'b', "c"}, {'c', "a"}},
                                     {{'a', "b"}, {'b', "bc"}, {'c', "c"}},
                                     {{'a', "c"}, {'c', "ca"}}});
    CHECK_THROWS_AS(membership(system, word_of(system, "abcab"), budget), BoundReached);
}

TEST_CASE(
    "a derivation by many tables is not made where their lengths take more memory than allowed") {
    const ET0L system = oracle::et0l_of({"a", {{{'a', {"a"}}}, {{'a', {"a"}}}}, "a"});
    const Membership found{true, Reason::derived, 1000, 0, 0, 0, std::vector<std::uint32_t>(1000)};
    Budget budget;
    CHECK(derivation(system, {0}, found, budget).words.size() == 1001);
    budget.memory = 10'000;  // a number of eight bytes or more for each step and letter
    CHECK_THROWS_AS(derivation(system, {0}, found, budget), BoundReached);
}
