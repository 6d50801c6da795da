#include "exact/exact.hpp"

#include <doctest/doctest.h>

using namespace algae;

TEST_CASE("a pair of brackets counts what the monoid says it counts") {
    CHECK(Sums{2}.branch(3) == 5);
    CHECK(Sums{0}.branch(3) == 3);
}

TEST_CASE("vectors add entry by entry") {
    std::vector<Integer> left{1, 2, 3};
    Vectors{3}.append(left, {10, -2, 0});
    CHECK(left == std::vector<Integer>{11, 0, 3});
    CHECK(Vectors{2}.one() == std::vector<Integer>{0, 0});
}

TEST_CASE("a word is balanced when it neither ends nor ever dips away from 0") {
    const BracketBalance::value_type open{1, 0}, close{-1, -1};
    const BracketBalance balances;
    const auto product = [&](std::initializer_list<BracketBalance::value_type> parts) {
        auto value = balances.one();
        for (const auto& part : parts) balances.append(value, part);
        return value;
    };
    CHECK(product({open, close}) == balances.one());
    CHECK(product({close, open}) == BracketBalance::value_type{0, -1});
    CHECK(product({open, open, close}) == BracketBalance::value_type{1, 0});
    CHECK(product({open, close, close, close}) == BracketBalance::value_type{-2, -2});
}
