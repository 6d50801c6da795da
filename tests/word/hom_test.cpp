#include "word/word.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "exact/exact.hpp"
#include "oracle/random_systems.hpp"

using namespace algae;

namespace {

/// Letter 0 counts 1, brackets are 1 and 2; a pair of brackets counts 100.
const Hom<Sums> counting{Sums{100}, {1, 0, 0}, Brackets{1, 2}};

}  // namespace

TEST_CASE("a homomorphism sends a word to the product of its letters' images") {
    const Hom<Words> h{Words{}, {{0, 1}, {}}};
    CHECK(h({0, 1, 0}) == Word{0, 1, 0, 1});
    CHECK(h({}) == Word{});
    CHECK_THROWS(h({2}));
}

TEST_CASE("brackets that match become branches") {
    CHECK(counting({0, 1, 0, 1, 2, 2, 0}) == 203);
    CHECK(counting({}) == 0);
}

TEST_CASE("brackets that do not match are an error") {
    CHECK_THROWS_WITH_AS(counting({0, 2}), "unmatched ']'", Error);
    CHECK_THROWS_WITH_AS(counting({0, 1, 0}), "'[' is never closed", Error);
    CHECK_THROWS_WITH_AS(counting({2, 1}), "unmatched ']'", Error);
}

TEST_CASE("after() is composition") {
    const bool holds = rc::check("(phi . h)(w) = phi(h(w))", [] {
        const auto word_of = [](const std::string& text) {
            Word word;
            for (const char letter : text) word.push_back(static_cast<Symbol>(letter - 'a'));
            return word;
        };
        const auto any = [&] { return word_of(*oracle::any_word("abc", 5)); };
        const Hom<Words> h{Words{}, {any(), any(), any()}}, phi{Words{}, {any(), any(), any()}};
        const Word word = any();
        RC_ASSERT(phi.after(h, {0, 1, 2})(word) == phi(h(word)));
    });
    CHECK(holds);
}

TEST_CASE("an alphabet has brackets if it has both") {
    Alphabet alphabet;
    alphabet.symbol("F");
    alphabet.symbol("]");
    CHECK(!brackets_of(alphabet));
    alphabet.symbol("[");
    CHECK(brackets_of(alphabet) == Brackets{2, 1});
}
