#include "language/detail/equality.hpp"
#include "language/language.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <set>

#include "exact/exact.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

namespace {

/// The words of generations 0, 1, ... as long as they are not too many or too long.
std::vector<std::string> first_words(const oracle::WrittenSystem& system, std::size_t most,
                                     std::size_t longest) {
    std::vector<std::string> words;
    oracle::WrittenSystem from = system;
    while (words.size() < most && from.axiom.size() <= longest) {
        words.push_back(from.axiom);
        from.axiom = oracle::rewritten(from, 1);
    }
    return words;
}

/// The first words of two sequences agree with what was found, by looking for each among many of the other's.
void check(const oracle::WrittenSystem& left, const oracle::WrittenSystem& right,
           const LanguageEquality& found) {
    REQUIRE(found.equal == !found.difference);
    const auto lefts = first_words(left, 60, 4000), rights = first_words(right, 60, 4000);
    const std::set<std::string> in_left(lefts.begin(), lefts.end()),
        in_right(rights.begin(), rights.end());
    if (!found.equal) {
        const auto& difference = *found.difference;
        const auto& own = difference.in_left ? lefts : rights;
        const auto& other = difference.in_left ? in_right : in_left;
        if (difference.generation >= own.size()) return;
        const std::string& word = own[difference.generation];
        CHECK(!other.contains(word));
        CHECK(difference.length == Integer(word.size()));
        REQUIRE(difference.word.has_value());
        CHECK(oracle::text_of(
                  *over_common_alphabet(oracle::d0l_of(left), oracle::d0l_of(right)).alphabet,
                  *difference.word) == word);
        return;
    }
    // Words of the first half are all among the other's, unless those end at words too long.
    for (std::size_t n = 0; n < lefts.size() / 4; ++n) CHECK(in_right.contains(lefts[n]));
    for (std::size_t n = 0; n < rights.size() / 4; ++n) CHECK(in_left.contains(rights[n]));
    if (found.finite) return;
    for (const auto& [n, m] : found.words)
        if (n < lefts.size() && m < rights.size()) CHECK(lefts[n] == rights[m]);
    for (const SectionMatch& match : found.sections) {
        std::uint64_t n = match.section.left, m = match.section.right;
        for (; n < lefts.size() && m < rights.size();
             n += match.section.step, m += match.section.stride)
            CHECK(lefts[n] == rights[m]);
    }
}

LanguageEquality decided(const oracle::WrittenSystem& left, const oracle::WrittenSystem& right) {
    LanguageEquality found = equal_languages(oracle::d0l_of(left), oracle::d0l_of(right));
    check(left, right, found);
    return found;
}

}  // namespace

TEST_CASE("languages of any two systems") {
    std::size_t equal = 0, finite = 0;
    const bool agrees = rc::check("equal languages", [&] {
        const auto left = *oracle::any_d0l(), right = *oracle::any_d0l();
        const LanguageEquality found = decided(left, right);
        if (found.equal) ++(found.finite ? finite : equal);
        RC_ASSERT(decided(left, left).equal);
    });
    CHECK(agrees);
    CHECK(finite > 0);
}

TEST_CASE("all pairs of small binary systems, against the sets of their first words") {
    std::vector<std::string> words{""};
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i].size() < 2)
            for (const char a : {'a', 'b'}) words.push_back(words[i] + a);
    std::vector<oracle::WrittenSystem> systems;
    for (const std::string axiom : {"a", "b", "ab", "ba", "bb"})
        for (const std::string& a : words)
            for (const std::string& b : words) systems.push_back({axiom, {{'a', {a}}, {'b', {b}}}});
    std::size_t equal = 0;
    for (std::size_t i = 0; i < systems.size(); ++i)
        for (std::size_t j = i % 3; j < i; j += 3) {
            const auto one = first_words(systems[i], 12, 300),
                       two = first_words(systems[j], 12, 300);
            const std::set<std::string> left(one.begin(), one.end()), right(two.begin(), two.end());
            // Short words that appear in one only show that languages differ; lengths do not go back far here.
            bool differ = false;
            for (const std::string& word : one) differ |= word.size() <= 8 && !right.contains(word);
            for (const std::string& word : two) differ |= word.size() <= 8 && !left.contains(word);
            const LanguageEquality found = decided(systems[i], systems[j]);
            CHECK(found.equal == !differ);
            equal += found.equal;
        }
    CHECK(equal > 50);
}

TEST_CASE("languages that are the same in another order") {
    const oracle::WrittenSystem system{"ab", {{'a', {"b"}}, {'b', {"aa"}}}};
    const LanguageEquality same = decided(system, system);
    REQUIRE(same.sections.size() == 1);
    CHECK(same.sections[0].section == Section{0, 1, 0, 1});

    // The first two words are exchanged.
    const LanguageEquality exchanged = decided({"x", {{'x', {"y"}}, {'y', {"S"}}, {'S', {"Sa"}}}},
                                               {"y", {{'y', {"x"}}, {'x', {"S"}}, {'S', {"Sa"}}}});
    CHECK(exchanged.equal);
    CHECK(exchanged.words == std::vector<std::pair<std::uint64_t, std::uint64_t>>{{0, 1}, {1, 0}});
    REQUIRE(exchanged.sections.size() == 1);
    CHECK(exchanged.sections[0].section == Section{2, 1, 2, 1});

    // Generations 2n and 2n + 1 are S X^n and T X^n on the left, the other way round on the right.
    const LanguageEquality turned =
        decided({"S", {{'S', {"T"}}, {'T', {"SX"}}}}, {"T", {{'T', {"S"}}, {'S', {"TX"}}}});
    CHECK(turned.equal);
    REQUIRE(turned.sections.size() == 2);
    CHECK(turned.sections[0].section == Section{0, 2, 1, 2});
    CHECK(turned.sections[1].section == Section{1, 2, 0, 2});

    // Here it is not: T X comes after S X.
    CHECK_FALSE(
        decided({"S", {{'S', {"T"}}, {'T', {"SX"}}}}, {"T", {{'T', {"SX"}}, {'S', {"T"}}}}).equal);
}

TEST_CASE("exponential sections in another order, with erasing") {
    // Left: S a^(2^n), T a^(2^n); right the same words with T first.
    const LanguageEquality found = decided({"Sa", {{'S', {"T"}}, {'T', {"Saa"}}, {'a', {"a"}}}},
                                           {"Ta", {{'T', {"S"}}, {'S', {"Taa"}}, {'a', {"a"}}}});
    CHECK(found.equal);
    const LanguageEquality doubled = decided({"Sa", {{'S', {"T"}}, {'T', {"S"}}, {'a', {"aa"}}}},
                                             {"Sa", {{'S', {"T"}}, {'T', {"S"}}, {'a', {"aa"}}}});
    CHECK(doubled.equal);
    CHECK(decided({"ab", {{'a', {""}}, {'b', {"aabb"}}}}, {"ab", {{'a', {"aabb"}}, {'b', {""}}}})
              .equal);
}

TEST_CASE("the same letters in another order are another word") {
    const LanguageEquality found =
        decided({"ab", {{'a', {"aab"}}, {'b', {"b"}}}}, {"ab", {{'a', {"aba"}}, {'b', {"b"}}}});
    REQUIRE(!found.equal);
    CHECK(found.difference->in_left);
    CHECK(found.difference->generation == 1);
    CHECK(found.difference->alike == 1);
}

TEST_CASE("finite languages by their words") {
    const LanguageEquality found =
        decided({"ab", {{'a', {"b"}}, {'b', {"a"}}}}, {"ba", {{'a', {"ba"}}, {'b', {""}}}});
    CHECK_FALSE(found.equal);
    const LanguageEquality equal =
        decided({"ab", {{'a', {"b"}}, {'b', {"a"}}}}, {"ba", {{'a', {"b"}}, {'b', {"a"}}}});
    CHECK(equal.equal);
    CHECK(equal.finite);
    CHECK(equal.words_in_all == 2);
    const LanguageEquality one = decided({"a", {{'a', {"b"}}}}, {"a", {{'a', {"ab"}}}});
    CHECK_FALSE(one.equal);
    CHECK(decided({"a", {{'a', {"ab"}}}}, {"a", {{'a', {"b"}}}}).difference->in_left);
}

TEST_CASE("words too long to be written still decide") {
    // Both double; the sequences differ in generation 40, whose words have more than 2^40 letters.
    oracle::WrittenSystem left{"!d", {{'d', {"dd"}}}}, right = left;
    for (char a = '!'; a < '!' + 40; ++a)
        left.successors[a] = right.successors[a] = {std::string(1, static_cast<char>(a + 1))};
    left.successors['!' + 39] = {"xy"};
    right.successors['!' + 39] = {"yx"};
    const LanguageEquality found = equal_languages(oracle::d0l_of(left), oracle::d0l_of(right));
    REQUIRE(!found.equal);
    CHECK(found.difference->generation == 40);
    CHECK(found.difference->alike == 40);
    CHECK(!found.difference->word);
}

TEST_CASE("progressions that cover all numbers") {
    CHECK(covers_all({}, {{0, 1}}));
    CHECK(covers_all({0, 3}, {{1, 3}, {2, 3}, {6, 3}}));
    CHECK_FALSE(covers_all({0}, {{1, 3}, {2, 3}, {6, 3}}));
    CHECK_FALSE(covers_all({0, 1, 2, 3}, {}));
}

TEST_CASE("a bound that is reached is no answer") {
    Budget budget;
    budget.memory = 500;
    CHECK_THROWS_AS(equal_languages(d0l("a", {{'a', "ab"}}), d0l("a", {{'a', "ab"}}), budget),
                    BoundReached);
}
