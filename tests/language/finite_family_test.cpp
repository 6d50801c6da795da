#include "language/detail/finite_family.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <random>

#include "oracle/finite_systems.hpp"
#include "verify/verify.hpp"

using namespace algae;
using oracle::FiniteSystems;

namespace {

/// The languages over so many letters, words up to so long, that are decided to be of the family.
/// Every system and every proof that comes with an answer is checked.
std::set<std::uint64_t> decided(int letters, std::size_t longest, Family family) {
    const auto words = FiniteSystems::words(letters, longest);
    std::set<std::uint64_t> languages;
    for (std::uint64_t bits = 1; bits < std::uint64_t{1} << words.size(); ++bits) {
        const FiniteLanguage language = finite_language(oracle::words_of(words, bits));
        const FamilyAnswer answer = decide_family(language, family);
        INFO(to_string(language), " ", to_string(family));
        if (answer.truth == Truth::proved) {
            languages.insert(bits);
            CHECK(generates(answer.witness.value(), language, family));
        } else {
            REQUIRE(answer.truth == Truth::refuted);
            CHECK(flaw_in(answer.obstruction.value()).value_or("sound") == "sound");
        }
    }
    return languages;
}

bool is_of(const std::vector<std::string>& words, const std::string& family) {
    const FamilyAnswer answer = decide_family(finite_language(words), family_named(family));
    REQUIRE(answer.truth != Truth::undecided);
    return answer.truth == Truth::proved;
}

}  // namespace

TEST_CASE("the languages of words of at most six letters a, counted by family") {
    const std::map<std::string, std::size_t> counts = {{"0L", 17},   {"P0L", 6},  {"D0L", 12},
                                                       {"PD0L", 6},  {"T0L", 17}, {"PT0L", 6},
                                                       {"DT0L", 12}, {"PDT0L", 6}};
    for (const auto& [name, count] : counts)
        CHECK(decided(1, 6, family_named(name)).size() == count);
}

TEST_CASE("the languages of words of at most two letters a and b, counted by family") {
    const std::map<std::string, std::size_t> counts = {{"0L", 80},   {"P0L", 18},  {"D0L", 37},
                                                       {"PD0L", 15}, {"T0L", 89},  {"PT0L", 20},
                                                       {"DT0L", 82}, {"PDT0L", 20}};
    for (const auto& [name, count] : counts)
        CHECK(decided(2, 2, family_named(name)).size() == count);
}

TEST_CASE("the decision agrees with writing down and running all small systems") {
    for (const auto& [letters, longest] : {std::pair{1, 6}, {2, 2}, {3, 1}})
        for (const Family family : all_families()) {
            const FiniteSystems systems(letters, static_cast<std::size_t>(longest),
                                        family.propagating, family.deterministic);
            CHECK(decided(letters, static_cast<std::size_t>(longest), family) ==
                  (family.tables ? systems.with_tables() : systems.without_tables()));
        }
}

TEST_CASE("all deterministic systems over words of at most three letters a and b") {
    for (const char* name : {"D0L", "PD0L"}) {
        const Family family = family_named(name);
        CHECK(decided(2, 3, family) ==
              FiniteSystems(2, 3, family.propagating, true).without_tables());
    }
}

TEST_CASE(
    "all 32767 languages over a and b with words of at most three letters are decided for 0L") {
    const std::set<std::uint64_t> languages = decided(2, 3, Family{});
    const auto deterministic = FiniteSystems(2, 3, false, true).without_tables();
    CHECK(std::includes(languages.begin(), languages.end(), deterministic.begin(),
                        deterministic.end()));
    CHECK(languages.size() > deterministic.size());
}

TEST_CASE("the witnesses of the closure table are in no family") {
    for (const Family family : all_families())
        for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
                 {"a", "aa"}, {"aa", "abb"}, {"ab", "ba", "aaa"}, {"ab", "aabb"}})
            CHECK_FALSE(is_of(words, to_string(family)));
}

TEST_CASE("witnesses that tell the families apart") {
    CHECK(is_of({"", "a", "aa"}, "0L"));
    CHECK_FALSE(is_of({"", "a", "aa"}, "P0L"));
    CHECK_FALSE(is_of({"", "a", "aa"}, "D0L"));
    CHECK(is_of({"a", "bb"}, "PD0L"));
    CHECK_FALSE(is_of({"", "a"}, "P0L"));
    CHECK(is_of({"a", "b", "aa"}, "P0L"));
    CHECK(is_of({"", "a", "aab"}, "D0L"));
    CHECK_FALSE(is_of({"", "aa", "ab", "ba", "bb"}, "0L"));
    CHECK(is_of({"", "aa", "ab", "ba", "bb"}, "T0L"));
    CHECK_FALSE(is_of({"aa", "ab", "ba", "bb"}, "D0L"));
    CHECK(is_of({"aa", "ab", "ba", "bb"}, "P0L"));
}

TEST_CASE("an empty axiom only where it is allowed") {
    const FiniteLanguage empty_word = finite_language({""});
    CHECK(decide_family(empty_word, Family{}).truth == Truth::refuted);
    FamilyOptions allowed;
    allowed.empty_axiom = true;
    for (const Family family : all_families()) {
        const FamilyAnswer answer = decide_family(empty_word, family, allowed);
        REQUIRE(answer.truth == Truth::proved);
        CHECK(generates(*answer.witness, empty_word, family));
        CHECK(answer.witness->axiom.empty());
    }
    CHECK(decide_family(finite_language({"", "a"}), family_named("P0L"), allowed).truth ==
          Truth::refuted);
}

TEST_CASE("no system generates the empty language") {
    for (const Family family : all_families()) {
        const FamilyAnswer answer = decide_family(finite_language({}), family);
        REQUIRE(answer.truth == Truth::refuted);
        CHECK(!flaw_in(*answer.obstruction));
    }
}

TEST_CASE("a bound that is reached is undecided, never no") {
    FamilyOptions options;
    options.cases = 0;
    const FamilyAnswer answer = decide_family(finite_language({"a", "aa"}), Family{}, options);
    CHECK(answer.truth == Truth::undecided);
    CHECK(answer.tried ==
          "Rules were ruled out case by case, but the bound on the number of cases was reached "
          "before the answer was known.");
    Budget budget;
    budget.memory = 10;
    CHECK(decide_family(finite_language({"a", "aa"}), Family{}, {}, budget).truth ==
          Truth::undecided);
    budget = {};
    budget.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    CHECK(decide_family(finite_language({"a", "aa"}), Family{}, {}, budget).truth ==
          Truth::undecided);
}

TEST_CASE("twelve words of up to eight letters over three letters are decided at once") {
    std::mt19937_64 generator(2026);
    for (int round = 0; round < 40; ++round) {
        std::vector<std::string> words;
        const std::size_t letters = 1 + generator() % 3;
        while (words.size() < 12) {
            std::string& word = words.emplace_back();
            for (std::size_t size = generator() % 9; word.size() < size;)
                word += "abc"[round % 2 == 0 ? generator() % letters
                                             : generator() % 4 / 3 * (generator() % letters)];
        }
        const FiniteLanguage language = finite_language(words);
        for (const Family family : all_families()) {
            Budget budget;
            budget.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
            const FamilyAnswer answer = decide_family(language, family, {}, budget);
            INFO(to_string(language), " ", to_string(family));
            REQUIRE(answer.truth != Truth::undecided);
            if (answer.witness) CHECK(generates(*answer.witness, language, family));
            if (answer.obstruction) CHECK(!flaw_in(*answer.obstruction));
        }
    }
}

TEST_CASE("factors that words share count once against the memory") {
    std::vector<std::string> words;
    for (std::size_t n = 1; n <= 300; ++n) words.emplace_back(n, 'a');
    const FiniteLanguage language = finite_language(words);
    for (const char* const name : {"0L", "D0L", "PT0L"}) {
        const FamilyAnswer answer = decide_family(language, family_named(name));
        INFO(name, " ", answer.tried);
        REQUIRE(answer.truth == Truth::refuted);
        CHECK(flaw_in(answer.obstruction.value()).value_or("sound") == "sound");
    }
    words.emplace_back();
    const FamilyAnswer with_empty = decide_family(finite_language(words), Family{});
    REQUIRE(with_empty.truth == Truth::proved);
    CHECK(generates(with_empty.witness.value(), finite_language(words), Family{}));

    // The factors of one long word without repetitions are counted too: there are 5 million letters in them.
    std::mt19937_64 generator(18);
    std::string word;
    while (word.size() < 300) word += "abcdef"[generator() % 6];
    Budget budget;
    budget.memory = 10'000'000;
    const FamilyAnswer bounded = decide_family(finite_language({word}), Family{}, {}, budget);
    CHECK(bounded.truth == Truth::undecided);
    CHECK(bounded.tried.find("the factors of the words of the language would take more than") !=
          std::string::npos);
    const auto obstruction = decide_family(language, Family{}).obstruction.value();
    budget.memory = 10'000;
    CHECK_THROWS_WITH_AS(static_cast<void>(flaw_in(obstruction, budget)),
                         doctest::Contains("the factors of the words would take more than"),
                         BoundReached);
}

TEST_CASE("reversal changes nothing, and the largest family has what the smaller ones have") {
    CHECK(rc::check([] {
        const auto words = *rc::gen::container<std::vector<std::string>>(
            rc::gen::mapcat(rc::gen::inRange(0, 5), [](int size) {
                return rc::gen::container<std::string>(static_cast<std::size_t>(size),
                                                       rc::gen::elementOf(std::string("aab")));
            }));
        if (words.size() > 10) return;
        const FiniteLanguage language = finite_language(words);
        std::vector<Word> reversed = language.words;
        for (Word& word : reversed) std::reverse(word.begin(), word.end());
        for (const Family family : all_families()) {
            const FamilyAnswer answer = decide_family(language, family);
            const FamilyAnswer mirror =
                decide_family(make_finite_language(language.alphabet, reversed), family);
            RC_ASSERT(answer.truth == mirror.truth);
            RC_ASSERT(answer.truth != Truth::undecided);
            if (answer.witness) {
                Family wider = family;
                wider.deterministic = wider.propagating = false;
                wider.tables = true;
                RC_ASSERT(decide_family(language, wider).truth == Truth::proved);
                RC_ASSERT(generates(*answer.witness, language, family));
            } else {
                RC_ASSERT(!flaw_in(*answer.obstruction));
            }
        }
    }));
}
