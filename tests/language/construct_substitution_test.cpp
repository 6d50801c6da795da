#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "language/construct_any.hpp"
#include "language/detail/construct.hpp"

using namespace algae;
using namespace algae::construct_tests;

TEST_CASE("substitution is what it is on sets of words") {
    CHECK(rc::check("substitution", [] {
        const ET0L system = any_system({2, true, false, 2}), a = any_system({1, true, false, 2}),
                   b = any_system({1, true, false, 2});
        RC_LOG() << text_of(system) << "\n" << text_of(a) << "\n" << text_of(b);
        const ET0L result = substituted(system, {{0, a}, {1, b}});
        require_form(result, system.tables.size() + a.tables.size() + b.tables.size() + 1);
        const oracle::Meaning meaning{{0, words_of(a, 3)}, {1, words_of(b, 3)}};
        RC_ASSERT(words_of(result, 3) == words_of(system, meaning, 3));
    }));
}

TEST_CASE("inverse images are what they are on sets of words") {
    CHECK(rc::check("inverse image", [] {
        const ET0L system =
            any_system({*rc::gen::element(1, 1, 2), true, *rc::gen::arbitrary<bool>(), 2});
        const Morphism morphism{{0, any_word_over(2, 0, 2)}, {1, any_word_over(2, 0, 2)}};
        RC_LOG() << text_of(system);
        const auto words = words_of(system, 6);
        std::set<Word> expected;
        std::vector<Word> tried{{}};
        for (std::size_t i = 0; i < tried.size(); ++i) {
            Word image;
            for (const Symbol a : tried[i])
                image.insert(image.end(), morphism[a].begin(), morphism[a].end());
            if (words.contains(image)) expected.insert(tried[i]);
            if (tried[i].size() < 3)
                for (const Symbol a : {0u, 1u}) {
                    tried.push_back(tried[i]);
                    tried.back().push_back(a);
                }
        }
        const ET0L result = table_inverse_image(system, morphism);
        require_form(result, result.tables.size());
        RC_ASSERT(words_of(result, 3) == expected);
    }));
}

TEST_CASE("a letter without a language is refused") {
    const ET0L system = et0l("ab", {{{'a', "aa"}}});
    CHECK_THROWS_WITH_AS(substituted(system, {{0, system}}),
                         "expected a language for every letter, found none for the letter b",
                         Error);
}

TEST_CASE("an inverse image that is in no family of E0L systems") {
    // All words over a and b with 2^n letters.
    const ET0L powers = et0l("a", {{{'a', "aa"}, {'b', "b"}}}, "ab");
    const ET0L result = table_inverse_image(powers, {{0, {0}}, {1, {0}}});
    const auto words = oracle::short_words(result, 4);
    REQUIRE(words);
    CHECK(words->size() == 2 + 4 + 16);
}
