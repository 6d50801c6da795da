#include <doctest/doctest.h>

#include "exact/exact.hpp"
#include "language/construct_any.hpp"
#include "language/detail/construct.hpp"

using namespace algae;
using namespace algae::construct_tests;

namespace {

constexpr std::size_t longest = 4, short_length = 3;

/// Every successor of a terminal is a letter that derives itself only and is no terminal.
bool is_synchronised(const ET0L& system) {
    for (const Table& table : system.tables)
        for (Symbol a = 0; a < table.size(); ++a)
            if (system.terminal[a])
                for (const Word& word : table[a]) {
                    if (word.size() != 1 || system.terminal[word[0]]) return false;
                    for (const Table& other : system.tables)
                        if (other[word[0]] != std::vector<Word>{word}) return false;
                }
    return true;
}

}  // namespace

TEST_CASE("the exact oracle finds what trying everything finds, where nothing is erased") {
    CHECK(rc::check("two oracles", [] {
        const ET0L system = any_system({2, false, false, 2});
        const auto tried = oracle::table_words(system, 4, 4);
        if (!tried) RC_DISCARD("too many words");
        RC_LOG() << text_of(system);
        RC_ASSERT(words_of(system, 4) == *tried);
    }));
}

TEST_CASE("a synchronised system has the same words, and its terminals fail") {
    CHECK(rc::check("synchronised", [] {
        const ET0L system = any_system({2, true, false, 2});
        RC_LOG() << text_of(system);
        const ET0L result = synchronised(system);
        require_form(result, system.tables.size());
        RC_ASSERT(is_synchronised(result));
        RC_ASSERT(result.axiom.size() == 1u);
        RC_ASSERT(words_of(result, longest) == words_of(system, longest));
    }));
}

TEST_CASE("rational operations on E0L systems are what they are on sets of words") {
    CHECK(rc::check("E0L", [] {
        const ET0L left = any_system({1, true, false, 2}), right = any_system({1, true, false, 2});
        RC_LOG() << text_of(left) << "\n" << text_of(right);
        const auto first = words_of(left, longest), second = words_of(right, longest);
        const ET0L sum = e0l_union(left, right), product = e0l_concatenation(left, right),
                   plus = e0l_plus(left), star = e0l_star(left);
        for (const ET0L* result : {&sum, &product, &plus, &star}) require_form(*result, 1);
        RC_ASSERT(words_of(sum, longest) == united(first, second));
        RC_ASSERT(words_of(product, longest) == products(first, second, longest));
        RC_ASSERT(words_of(plus, longest) == several(first, longest));
        RC_ASSERT(words_of(star, longest) == united(several(first, longest), {{}}));
    }));
}

TEST_CASE("rational operations on ET0L and EDT0L systems are what they are on sets of words") {
    for (const bool deterministic : {false, true})
        CHECK(rc::check("tables", [deterministic] {
            const ET0L left = any_system({2, true, deterministic, 2}),
                       right = any_system({1, true, deterministic, 2});
            RC_LOG() << text_of(left) << "\n" << text_of(right);
            const auto first = words_of(left, short_length), second = words_of(right, short_length);
            const ET0L sum = table_union(left, right), product = table_concatenation(left, right),
                       plus = table_plus(left), star = table_star(left);
            require_form(sum, left.tables.size() + right.tables.size() + 1);
            require_form(product, left.tables.size() + right.tables.size() + 1);
            require_form(plus, left.tables.size() + 2);
            require_form(star, left.tables.size() + 2);
            if (deterministic)
                for (const ET0L* result : {&sum, &product, &plus, &star})
                    RC_ASSERT(is_deterministic(*result));
            RC_ASSERT(words_of(sum, short_length) == united(first, second));
            RC_ASSERT(words_of(product, short_length) == products(first, second, short_length));
            RC_ASSERT(words_of(plus, short_length) == several(first, short_length));
            RC_ASSERT(words_of(star, short_length) == united(several(first, short_length), {{}}));
        }));
}

TEST_CASE("letters of two alphabets meet by name") {
    const ET0L left = et0l("aX", {{{'a', "aa"}, {'X', "b"}}}, "ab"),
               right = et0l("b", {{{'b', "X"}}}, "bX");
    for (const ET0L& sum : {e0l_union(left, right), table_union(left, right)}) {
        const Symbol a = *sum.alphabet->find("a"), b = *sum.alphabet->find("b"),
                     x = *sum.alphabet->find("X");
        CHECK(a == *left.alphabet->find("a"));
        CHECK(oracle::short_words(sum, 3) == std::set<Word>{{b}, {x}, {a, a, b}});
    }
}

TEST_CASE("operations of E0L refuse several tables") {
    const ET0L two = et0l("a", {{{'a', "aa"}}, {{'a', "aaa"}}});
    CHECK_THROWS_WITH_AS(e0l_star(two), "star needs an E0L system: expected one table, found 2",
                         Error);
}

TEST_CASE("a system without words has no letters but its terminals and one that fails") {
    const ET0L none = et0l("X", {{{'X', "X"}}}, "a"), some = et0l("Y", {{{'Y', "b"}}}, "b");
    for (const ET0L& product : {e0l_concatenation(none, some), e0l_concatenation(some, none)}) {
        CHECK(oracle::short_words(product, 3) == std::set<Word>());
        CHECK(product.alphabet->size() == 4);  // those of the first one, the other terminal, F
    }
}
