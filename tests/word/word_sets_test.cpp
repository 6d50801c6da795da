#include "word/word.hpp"

#include <doctest/doctest.h>

#include "exact/exact.hpp"

using namespace algae;

TEST_CASE("shortlex order: shorter words first") {
    CHECK(shortlex_less({1}, {0, 0}));
    CHECK(shortlex_less({0, 1}, {1, 0}));
    CHECK(!shortlex_less({0}, {0}));
    CHECK(!shortlex_less({}, {}));
}

TEST_CASE("products of sets are cut, sorted and without duplicates") {
    const Budget budget;
    const WordSets sets(budget, 2);
    std::vector<Word> left{{}, {0}, {0, 0}};
    sets.append(left, {{}, {0}, {1}});
    CHECK(left == std::vector<Word>{{}, {0}, {1}, {0, 0}, {0, 1}});
}

TEST_CASE("a set that takes more than the memory allowed is refused") {
    Budget budget;
    budget.memory = 1 << 20;
    const WordSets sets(budget);
    std::vector<Word> set{{0}, {1}};
    CHECK_THROWS_WITH_AS(
        [&] {
            for (int i = 0; i < 20; ++i) sets.append(set, {{0}, {1}});
        }(),
        "the set of words, one of those for each letter, would take more than an eighth of the 1 "
        "MiB allowed",
        BoundReached);
}
