#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "combinatorics/combinatorics.hpp"
#include "growth/expanded.hpp"
#include "growth/growth.hpp"

using namespace algae;

namespace {

std::vector<std::string> repeated_words(const D0L& system) {
    std::vector<std::string> words;
    for (const auto& repetition : infinite_repetitions(system))
        words.push_back(spell(*system.alphabet, repetition.word));
    return words;
}
using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("words without endless repetitions") {
    CHECK(repeated_words(d0l("a", {{'a', "ab"}, {'b', "a"}})).empty());  // no fourth powers
    CHECK(
        repeated_words(d0l("a", {{'a', "ab"}, {'b', "ba"}})).empty());  // no cubes but of overlaps
    CHECK(repeated_words(d0l("a", {{'a', "abc"}, {'b', "ac"}, {'c', "b"}})).empty());  // no squares
    CHECK(repeated_words(d0l("a", {{'a', "b"}, {'b', "a"}})).empty());
}

TEST_CASE("repetitions of growing letters, and of others") {
    CHECK(repeated_words(d0l("a", {{'a', "aba"}, {'b', "bbb"}})) == Texts{"b"});
    CHECK(repeated_words(
              d0l("ac", {{'a', "aba"}, {'b', "aba"}, {'c', "cd"}, {'d', "e"}, {'e', "d"}})) ==
          Texts{"de", "aab"});
    CHECK(repeated_words(d0l("a", {{'a', "abab"}, {'b', ""}})) == Texts{"ab"});
    CHECK(repeated_words(d0l("a", {{'a', "abc"}, {'b', "bb"}, {'c', "ccc"}})) == Texts{"b", "c"});
}

TEST_CASE("a morphism is made injective without changing what it does") {
    CHECK(rc::check([] {
        const auto written = *rc::gen::oneOf(any_growing_d0l(), oracle::any_d0l());
        const Iterated rest = skeleton(oracle::d0l_of(written));
        const Injective simple = made_injective(rest);
        Word word = rest.axiom, other = simple.system.axiom;
        for (std::size_t n = 0; n < simple.steps; ++n) word = rest.rules(word);
        for (int n = 0; n < 5 && word.size() < 10'000; ++n) {
            RC_ASSERT(simple.back(other) == word);
            word = rest.rules(word);
            other = simple.system.rules(other);
        }
    }));
}

TEST_CASE("endless repetitions are seen in the words, and high powers are among them") {
    CHECK(rc::check([] {
        const auto written = *rc::gen::oneOf(any_growing_d0l(), oracle::any_propagating_d0l());
        const D0L system = oracle::d0l_of(written);
        const auto repetitions = repeated_words(system);
        const auto words = expanded(written, 60'000, 200);
        for (const std::string& word : repetitions) {
            RC_PRE(word.size() < 200);
            RC_ASSERT(occurs(repeated(word, 3), words));
        }
        for (std::size_t length = 1; length <= 3; ++length)
            for (const std::string& word : factors_of(words, length)) {
                if (!occurs(repeated(word, 120), words)) continue;
                const bool known = std::any_of(
                    repetitions.begin(), repetitions.end(), [&](const std::string& other) {
                        return repeated(other, 3 * length + 3).find(repeated(word, 3)) !=
                               std::string::npos;
                    });
                RC_ASSERT(known);
            }
    }));
}

TEST_CASE("roots, conjugates and factors of powers") {
    CHECK(rc::check([] {
        const auto z = *rc::gen::nonEmpty(
            rc::gen::resize(6, rc::gen::container<Word>(rc::gen::inRange<Symbol>(0, 2))));
        const auto times = *rc::gen::inRange<std::size_t>(1, 4);
        Word power;
        for (std::size_t i = 0; i < times; ++i) power.insert(power.end(), z.begin(), z.end());
        RC_ASSERT(primitive_root(power) == primitive_root(z));
        Word least = z, turned = z;
        for (std::size_t i = 0; i < z.size(); ++i) {
            std::rotate(turned.begin(), turned.begin() + 1, turned.end());
            least = std::min(least, turned);
            RC_ASSERT(least_conjugate(turned) == least_conjugate(z));
        }
        RC_ASSERT(least_conjugate(z) == least);
        RC_ASSERT(is_factor_of_powers(power, z));
    }));
}
