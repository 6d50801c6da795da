#include "language/language.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <chrono>

#include "exact/exact.hpp"
#include "oracle/random_systems.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

/// All words over these letters of at most `longest` letters.
std::vector<std::string> all_texts(const std::string& letters, std::size_t longest) {
    std::vector<std::string> found{""};
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i].size() < longest)
            for (const char letter : letters) found.push_back(found[i] + letter);
    return found;
}

Word word_of(const OL& system, const std::string& text) {
    Word word;
    for (const char letter : text)
        word.push_back(system.alphabet->find(std::string(1, letter))
                           .value_or(static_cast<Symbol>(system.alphabet->size())));
    return word;
}

Membership asked(const OL& system, const std::string& text) {
    return membership(system, word_of(system, text));
}

/// A derivation of the word by nothing but the rules.
bool derives(const OL& system, const Word& word, std::uint64_t step) {
    const Derivation found = derivation(system, word, step);
    return is_derivation(system, found) && found.words.back() == word &&
           found.choices.size() == step;
}

using Reason = Membership::Reason;

}  // namespace

TEST_CASE("membership agrees with the list of all short words, and every yes has its derivation") {
    for (const bool erasing : {false, true}) {
        const bool holds = rc::check("every word of up to 4 letters", [=] {
            const auto written = *oracle::any_0l(3, erasing);
            const OL system = oracle::ol_of(written);
            const auto listed = words_up_to(system, 4);
            for (const std::string& text : all_texts("abc", 4)) {
                const Word word = word_of(system, text);
                const Membership found = membership(system, word);
                RC_ASSERT(found.member ==
                          (std::find(listed.begin(), listed.end(), word) != listed.end()));
                RC_ASSERT(found.member == (found.reason == Reason::derived));
                if (found.member) RC_ASSERT(derives(system, word, found.step));
            }
        });
        CHECK(holds);
    }
}

TEST_CASE("membership agrees with trying every choice, the first generation too") {
    const bool holds = rc::check("generations 0 to 3", [] {
        const auto written = *oracle::any_0l(2, true);
        const OL system = oracle::ol_of(written);
        std::set<std::string> before;
        for (unsigned n = 0; n <= 3; ++n) {
            const auto words = oracle::words_of_generation(written, n);
            if (words.size() > 200) break;
            for (const std::string& text : words)
                if (before.insert(text).second) {
                    const Membership found = asked(system, text);
                    RC_ASSERT(found.member);
                    RC_ASSERT(found.step == n);
                }
        }
    });
    CHECK(holds);
}

TEST_CASE("without erasing, what is not reached through words of the same length is no member") {
    const bool holds = rc::check("propagating", [] {
        const auto written = *oracle::any_0l(2, false);
        const OL system = oracle::ol_of(written);
        const auto reached = oracle::words_up_to(written, 4, 4);
        for (const std::string& text : all_texts("abc", 4))
            RC_ASSERT(asked(system, text).member == reached.contains(text));
    });
    CHECK(holds);
}

TEST_CASE("D0L systems, erasing or not, against rewriting") {
    const bool holds = rc::check("D0L", [] {
        const auto written = *oracle::any_d0l();
        const OL system = oracle::ol_of(written);
        const unsigned last = oracle::last_generation_within(written, 2000, 12);
        std::set<std::string> before;
        for (unsigned n = 0; n <= last; ++n) {
            const std::string text = oracle::rewritten(written, n);
            const Membership found = asked(system, text);
            RC_ASSERT(found.member);
            if (before.insert(text).second) RC_ASSERT(found.step == n);
            RC_ASSERT(derives(system, word_of(system, text), found.step));
            const std::string other = text + "a";
            if (asked(system, other).member)
                RC_ASSERT(derives(system, word_of(system, other), asked(system, other).step));
        }
    });
    CHECK(holds);
}

TEST_CASE("every no says why") {
    const OL doubling = ol("a", {{'a', "aa"}});
    CHECK(asked(doubling, "aaa").reason == Reason::outgrown);
    CHECK(asked(doubling, "aaa").step == 2);
    CHECK(asked(doubling, "ab").reason == Reason::foreign);
    CHECK(asked(doubling, "ab").position == 1);
    CHECK(asked(doubling, "").reason == Reason::outgrown);
    const Membership turns = asked(ol("ab", {{'a', "b"}, {'b', "a"}}), "aa");
    CHECK(turns.reason == Reason::periodic);
    CHECK(turns.step == turns.earlier + 2);
    const Membership two = asked(ol("a", {{'a', "aa"}, {'a', "aaa"}}), "");
    CHECK(two.reason == Reason::repeated);
    CHECK(two.earlier < two.step);
}

TEST_CASE("the empty word and empty axioms") {
    CHECK(asked(ol("a", {{'a', ""}}), "").step == 1);
    CHECK(asked(ol("a", {{'a', "bb"}, {'b', "c"}, {'b', ""}}), "").step == 2);
    CHECK(asked(ol("", {{'a', "aa"}}), "").step == 0);
    CHECK_FALSE(asked(ol("", {{'a', "aa"}}), "a").member);
    const OL deep = ol("1", {{'1', "22"}, {'2', "33"}, {'3', "44"}, {'4', "x"}, {'4', ""}});
    CHECK(asked(deep, "x").step == 4);
    CHECK(derives(deep, word_of(deep, "x"), 4));
    CHECK(asked(deep, "xxxxxxxx").step == 4);
    CHECK_FALSE(asked(deep, "xxxxxxxxx").member);
}

TEST_CASE("a word that appears only after all cycles have met") {
    // Cycles of 2, 3, 5 and 7 letters; the last step before all are back to the beginning.
    std::vector<std::pair<char, std::string>> rules;
    for (const std::string cycle : {"ab", "cde", "fghij", "klmnopq"})
        for (std::size_t i = 0; i < cycle.size(); ++i)
            rules.emplace_back(cycle[i], std::string(1, cycle[(i + 1) % cycle.size()]));
    CHECK(asked(ol("acfk", rules), "bejq").step == 209);
    rules.emplace_back('a', "b ");  // a choice, so that tables decide
    const OL system = ol("acfk", rules);
    CHECK(asked(system, "bejq").step == 209);
    CHECK(derives(system, word_of(system, "bejq"), 209));
    CHECK_FALSE(asked(system, "ae").member);
}

TEST_CASE("a derivation is refused for a generation that does not have the word") {
    const OL system = ol("a", {{'a', "a"}, {'a', "aa"}});
    CHECK_THROWS_WITH_AS(derivation(system, {0, 0, 0}, 1), "the word is not in generation 1",
                         Error);
    CHECK_THROWS_WITH_AS(derivation(ol("a", {{'a', "aa"}}), {0, 0}, 2),
                         "the word is not in generation 2", Error);
    CHECK_THROWS_WITH_AS(derivation(system, {7}, 1), "the word is not in generation 1", Error);
}

TEST_CASE("a derivation that was tampered with is none") {
    const OL system = ol("ab", {{'a', "a"}, {'a', "aa"}, {'b', ""}, {'b', "b"}});
    const Word word{0, 0, 0};
    const Derivation found = derivation(system, word, membership(system, word).step);
    REQUIRE(is_derivation(system, found));
    for (std::size_t t = 0; t < found.choices.size(); ++t)
        for (std::size_t i = 0; i < found.choices[t].size(); ++i) {
            Derivation other = found;
            other.choices[t][i] ^= 1;
            CHECK_FALSE(is_derivation(system, other));
        }
    Derivation other = found;
    other.words.back().push_back(0);
    CHECK_FALSE(is_derivation(system, other));
    CHECK_FALSE(is_derivation(system, Derivation{}));
}

TEST_CASE("tables that do not fit the memory allowed are refused") {
    Budget budget;
    budget.memory = 1000;
    CHECK_THROWS_AS(membership(ol("a", {{'a', "a"}, {'a', "aa"}}), Word(200, 0), budget),
                    BoundReached);
}

TEST_CASE("long words are decided") {
    const auto seconds = [](auto work) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    // Ten letters, each of which becomes itself and the next or the next alone; the last may vanish.
    std::vector<std::pair<char, std::string>> rules{{'j', "j"}, {'j', ""}};
    for (char letter = 'a'; letter < 'j'; ++letter) {
        const char next = static_cast<char>(letter + 1);
        rules.emplace_back(letter, std::string{letter, next});
        rules.emplace_back(letter, std::string(1, next));
    }
    const OL ten = ol("a", rules);
    const double ten_took = seconds([&] {
        CHECK(asked(ten, std::string(200, 'j')).member);
        CHECK_FALSE(asked(ten, std::string(199, 'j') + "a").member);
    });
    MESSAGE("two words of 200 letters, a 10-letter 0L system: " << ten_took << " s");
    const OL slow = ol("a", {{'a', "ab"}, {'b', "bc"}, {'c', "d"}, {'d', "d"}});
    const double took = seconds([&] {
        CHECK_FALSE(membership(slow, Word(2000, 0)).member);
        CHECK_FALSE(membership(ol("a", {{'a', "ab"}, {'b', "b"}}), Word(2000, 1)).member);
    });
    MESSAGE("2000 letters, PD0L systems: " << took << " s");
}

TEST_CASE("a derivation of many steps keeps the tables of few of them") {
    // 900 steps: all their tables would take almost three megabytes, every thirtieth and those between two do not.
    OL system = ol("ab", {{'a', "b"}, {'b', "a"}});
    system.successors[1].push_back({1});
    const Word word(100, 1);
    system.axiom = word;
    Budget budget;
    budget.memory = 250'000;
    const auto found = find_derivation(system, word, 900, budget);
    REQUIRE(found.has_value());
    CHECK(found->words.size() == 901);
    CHECK(found->words.back() == word);
}
