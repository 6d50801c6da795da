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

TEST_CASE(
    "a morphism sends a word to the images of its letters, and knows which letters have none") {
    const Morphism h{{0, {0, 1}}, {3, {}}};
    CHECK(h({0, 3, 0}) == Word{0, 1, 0, 1});
    CHECK(h({}) == Word{});
    CHECK(h.domain() == std::vector<Symbol>{0, 3});
    CHECK(h.erased() == std::vector<Symbol>{3});
    CHECK(h.size() == 4);
    CHECK(!h.maps(2));
    CHECK(!h.maps(4));
    CHECK(!h.image_of({0, 2}));
    CHECK_THROWS_AS(h({2}), Error);
    CHECK(h.mirrored() == Morphism{{0, {1, 0}}, {3, {}}});
}

TEST_CASE("a letter keeps its first image") {
    Morphism h;
    CHECK(h.add(1, {0}));
    CHECK(!h.add(1, {}));
    CHECK(h.add(0, {}));
    CHECK(h == Morphism(std::vector<Word>{{}, {0}}));
}

TEST_CASE("a morphism is printed as claims write it") {
    Alphabet alphabet;
    alphabet.symbol("a");
    alphabet.symbol("b");
    CHECK(to_string(Morphism{{1, {}}, {0, {0, 1}}}, alphabet) == "{ a -> ab; b -> ε }");
}

TEST_CASE("strong components: what one leads to has a smaller number") {
    CHECK(rc::check("against reachability", [] {
        const std::size_t count = *rc::gen::inRange<std::size_t>(0, 7);
        std::vector<std::vector<std::size_t>> successors(count);
        std::vector<std::vector<char>> leads(count, std::vector<char>(count, 0));
        for (std::size_t a = 0; a < count; ++a) {
            leads[a][a] = 1;
            successors[a] = *rc::gen::resize(3, rc::gen::container<std::vector<std::size_t>>(
                                                    rc::gen::inRange(std::size_t{0}, count)));
            for (const std::size_t b : successors[a]) leads[a][b] = 1;
        }
        for (std::size_t b = 0; b < count; ++b)
            for (std::size_t a = 0; a < count; ++a)
                for (std::size_t c = 0; c < count; ++c)
                    if (leads[a][b] && leads[b][c]) leads[a][c] = 1;
        const auto component = strong_components(successors);
        for (std::size_t a = 0; a < count; ++a)
            for (std::size_t b = 0; b < count; ++b) {
                RC_ASSERT((component[a] == component[b]) == (leads[a][b] && leads[b][a]));
                if (leads[a][b]) RC_ASSERT(component[b] <= component[a]);
            }
    }));
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
        const Morphism h(std::vector<Word>{any(), any(), any()});
        const Hom<Words> phi{Words{}, {any(), any(), any()}};
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
