#include "language/language.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exact/exact.hpp"
#include "language/detail/letters.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

namespace {

/// The language, if it is all there is when every choice has been tried until nothing new comes;
/// nothing as soon as a word has more than `longest` letters.
std::optional<std::set<std::string>> language_by_trying(const oracle::WrittenSystem& system,
                                                        std::size_t longest) {
    std::set<std::string> seen{system.axiom};
    std::vector<std::string> waiting{system.axiom};
    while (!waiting.empty()) {
        oracle::WrittenSystem from = system;
        from.axiom = waiting.back();
        waiting.pop_back();
        for (const std::string& word : oracle::words_of_generation(from, 1)) {
            if (word.size() > longest) return std::nullopt;
            if (seen.insert(word).second) waiting.push_back(word);
        }
    }
    return seen;
}

/// Whether the rules go round as the proof says, by nothing but looking at them.
bool holds(const OL& system, const EndlessRound& round) {
    const auto has = [](const Word& word, Symbol a) {
        return std::count(word.begin(), word.end(), a);
    };
    const auto successor = [&](const RuleUse& rule) {
        return system.successors[rule.letter].at(rule.choice);
    };
    if (round.rules.empty()) return false;
    for (std::size_t i = 0; i < round.rules.size(); ++i)
        if (!has(successor(round.rules[i]), round.rules[(i + 1) % round.rules.size()].letter))
            return false;
    const Symbol next = round.rules[1 % round.rules.size()].letter;
    const Word first = successor(round.rules.front());
    return has(first, round.other) >= (round.other == next ? 2 : 1) &&
           letter_futures(system).lasting[round.other];
}

}  // namespace

TEST_CASE("a language is finite if trying every choice ends, and then has as many words") {
    for (const bool erasing : {false, true}) {
        std::size_t ended = 0;
        const bool agrees = rc::check("finiteness", [&] {
            const auto written = *oracle::any_0l(2, erasing);
            const OL system = oracle::ol_of(written);
            const Finiteness found = finiteness(system);
            // Three letters, two in the axiom: no finite language has a word of more than 2 * 2^3 letters.
            const auto language = language_by_trying(written, 16);
            RC_ASSERT(found.finite == language.has_value());
            RC_ASSERT(found.finite != found.round.has_value());
            if (language) {
                RC_ASSERT(number_of_words(system) == Integer(language->size()));
                ++ended;
            } else {
                RC_ASSERT(holds(system, *found.round));
            }
        });
        CHECK(agrees);
        CHECK(ended > 0);
    }
}

TEST_CASE("the words of a D0L system repeat as rewriting shows") {
    std::size_t ended = 0;
    const bool agrees = rc::check("repetition", [&] {
        const auto written = *oracle::any_d0l();
        const OL system = oracle::ol_of(written);
        if (!finiteness(system).finite) {
            RC_ASSERT(oracle::rewritten(written, oracle::last_generation_within(written, 3000, 600))
                          .size() > 20);
            return;
        }
        ++ended;
        std::vector<std::string> words{written.axiom};
        std::size_t first = 0;
        for (;;) {
            oracle::WrittenSystem from = written;
            from.axiom = words.back();
            const std::string next = oracle::rewritten(from, 1);
            first = static_cast<std::size_t>(std::find(words.begin(), words.end(), next) -
                                             words.begin());
            if (first < words.size()) break;
            words.push_back(next);
        }
        RC_ASSERT(repetition(system) == (Repetition{first, Integer(words.size() - first)}));
        RC_ASSERT(number_of_words(system) == Integer(words.size()));
    });
    CHECK(agrees);
    CHECK(ended > 0);
}

TEST_CASE("finite and infinite languages with the least that makes the difference") {
    CHECK(finiteness(ol("a", {{'a', "ab"}, {'b', ""}})).finite);  // what is added dies
    CHECK_FALSE(finiteness(ol("a", {{'a', "ab"}, {'b', ""}, {'b', "b"}})).finite);  // or need not
    CHECK(finiteness(ol("c", {{'a', "aa"}})).finite);                 // not accessible
    CHECK(finiteness(ol("a", {{'a', "bbb"}, {'b', "ccc"}})).finite);  // grows, but not again
    CHECK(finiteness(ol("a", {{'a', "aa"}, {'a', ""}})).finite == false);
    CHECK(finiteness(ol("", {})).finite);
    CHECK(number_of_words(ol("", {})) == 1);
    CHECK(number_of_words(ol("aa", {{'a', ""}, {'a', "a"}})) == 3);
    CHECK(repetition(ol("mb", {{'b', "mb"}, {'m', ""}})) ==
          (Repetition{0, 1}));  // neither letter alone
}

TEST_CASE("a period of many cycles is not walked through") {
    std::vector<std::pair<char, std::string>> rules;
    char next = 33;
    std::string axiom;
    const auto cycle = [&](int length) {
        const char first = next;
        axiom += first;
        for (int i = 0; i < length; ++i, ++next)
            rules.emplace_back(
                next, std::string(1, i + 1 == length ? first : static_cast<char>(next + 1)));
    };
    for (const int length : {2, 3, 5, 7, 11, 13, 17, 19}) cycle(length);
    rules.emplace_back('z', axiom);
    CHECK(repetition(ol("z", rules)) == (Repetition{1, 9699690}));
    CHECK(number_of_words(ol("z", rules)) == 9699691);
}

TEST_CASE("what cannot be counted says so") {
    CHECK_THROWS_WITH_AS(number_of_words(ol("a", {{'a', "aa"}})), "the language is infinite",
                         Error);
    CHECK_THROWS_WITH_AS(repetition(ol("a", {{'a', "aa"}})),
                         "the language is infinite: no generation comes again", Error);
    CHECK_THROWS_WITH_AS(repetition(ol("a", {{'a', "a"}, {'a', ""}})),
                         "a letter has several rules: the generations are no sequence of words",
                         Error);
    Budget budget;
    budget.memory = 1 << 10;
    CHECK_THROWS_AS(number_of_words(ol("aaaaaaaaaaaaaaaaaaaa", {{'a', "b"}, {'a', "c"}}), budget),
                    BoundReached);
}

TEST_CASE("more words than could be listed are counted") {
    CHECK(number_of_words(ol(std::string(100, 'a'), {{'a', "b"}, {'a', "c"}})) ==
          power(Integer(2), 100) + 1);
    // The axiom, and 60 to 180 letters b.
    CHECK(number_of_words(ol(std::string(60, 'a'), {{'a', "b"}, {'a', "bb"}, {'a', "bbb"}})) ==
          1 + 121);
}

TEST_CASE("generations may have as many letters as the bound") {
    Budget budget;
    budget.letters = 3;
    CHECK(repetition(ol("ab", {{'a', "bb"}, {'b', "b"}}), budget) == (Repetition{1, 1}));
    budget.letters = 2;
    CHECK_THROWS_AS(repetition(ol("ab", {{'a', "bb"}, {'b', "b"}}), budget), BoundReached);
}
