#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "language/construct_any.hpp"
#include "language/detail/construct.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;
using namespace algae::construct_tests;

namespace {

constexpr std::size_t longest = 4;

/// The images of a and b: words over a and b, with an empty one now and then if `erasing`.
Substitution any_substitution(bool erasing, int most) {
    Substitution found;
    for (const Symbol a : {0u, 1u})
        for (int count = any_number(1, most); count > 0; --count)
            found[a].push_back(any_word_over(2, erasing ? 0 : 1, 2));
    return found;
}

oracle::Meaning meaning(const Substitution& images) {
    oracle::Meaning found;
    for (const auto& [a, words] : images) found[a] = {words.begin(), words.end()};
    return found;
}

}  // namespace

TEST_CASE("erasing rules are eliminated, the empty word alone is lost") {
    for (const int tables : {1, 2})
        CHECK(rc::check("propagating", [tables] {
            const ET0L system = any_system({tables, true, false, 2});
            RC_LOG() << text_of(system);
            const ET0L result = propagating(system);
            require_form(result, system.tables.size());
            RC_ASSERT(is_propagating(result));
            auto words = words_of(system, longest);
            RC_ASSERT(can_vanish(system, {}) == words.contains({}));
            words.erase(Word{});
            RC_ASSERT(words_of(result, longest) == words);
        }));
}

TEST_CASE(
    "images under homomorphisms and finite substitutions are what they are on sets of words") {
    for (const bool erasing : {false, true})
        for (const int most : {1, 2})
            CHECK(rc::check("images", [=] {
                const ET0L system = any_system({2, true, false, 2});
                const Substitution images = any_substitution(erasing, most);
                RC_LOG() << text_of(system);
                const auto words = words_of(system, meaning(images), longest);
                const ET0L one = e0l_image(system, images), more = table_image(system, images);
                require_form(one, system.tables.size());
                require_form(more, system.tables.size() + 1);
                RC_ASSERT(words_of(one, longest) == words);
                RC_ASSERT(words_of(more, longest) == words);
            }));
}

TEST_CASE("homomorphic images of EDT0L systems are EDT0L") {
    CHECK(rc::check("EDT0L", [] {
        const ET0L system = any_system({2, true, true, 2});
        const Substitution images = any_substitution(true, 1);
        const ET0L result = table_image(system, images);
        RC_ASSERT(is_deterministic(result));
        RC_ASSERT(words_of(result, longest) == words_of(system, meaning(images), longest));
    }));
}

TEST_CASE("a coding of an 0L language is E0L") {
    CHECK(rc::check("codings", [] {
        ET0L system = any_system({1, true, false, 2});
        system.terminal = {1, 1, 1, 1, 0};
        Substitution coding;
        for (Symbol a = 0; a < 4; ++a) coding[a] = {{static_cast<Symbol>(any_number(0, 1))}};
        const ET0L result = e0l_image(system, coding);
        require_form(result, 1);
        RC_ASSERT(words_of(result, longest) == words_of(system, meaning(coding), longest));
    }));
}

TEST_CASE("a letter without an image is refused if it occurs") {
    const ET0L system = et0l("ab", {{{'a', "aa"}}});
    CHECK_THROWS_WITH_AS(e0l_image(system, {{0, {{0}}}}),
                         "expected an image of every letter, found none of the letter b", Error);
    CHECK_THROWS_AS(table_image(system, {{0, {{0}}}}), Error);
    CHECK_NOTHROW(table_image(et0l("a", {{{'a', "aa"}, {'b', "a"}}}), {{0, {{0}}}}));
    CHECK_NOTHROW(e0l_image(et0l("a", {{{'a', "aa"}, {'b', "a"}}}), {{0, {{0}}}}));
}
