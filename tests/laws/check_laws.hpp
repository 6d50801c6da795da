#pragma once

#include <doctest/doctest.h>

#include <random>

#include "exact/exact.hpp"

namespace algae::laws {

/// The laws of a monoid on a thousand triples of elements. `any` gives a random element; `same` says
/// when two elements count as equal.
template <Monoid M, class Any, class Same>
void check_monoid_laws(const M& monoid, Any any, Same same) {
    const auto times = [&](auto left, const auto& right) {
        monoid.append(left, right);
        return left;
    };
    for (int i = 0; i < 1000; ++i) {
        const auto x = any(), y = any(), z = any();
        REQUIRE(same(times(times(x, y), z), times(x, times(y, z))));
        REQUIRE(same(times(monoid.one(), x), x));
        REQUIRE(same(times(x, monoid.one()), x));
    }
}

template <Monoid M, class Any>
void check_monoid_laws(const M& monoid, Any any) {
    check_monoid_laws(monoid, any, [](const auto& x, const auto& y) { return x == y; });
}

/// A twig grows beside the axis, so twigs at the same place may stand in any order.
template <Branching M, class Any, class Same>
void check_branching_laws(const M& monoid, Any any, Same same) {
    const auto times = [&](auto left, const auto& right) {
        monoid.append(left, right);
        return left;
    };
    for (int i = 0; i < 1000; ++i) {
        const auto x = any(), u = monoid.branch(any()), v = monoid.branch(any());
        REQUIRE(same(times(times(x, u), v), times(times(x, v), u)));
    }
}

template <Branching M, class Any>
void check_branching_laws(const M& monoid, Any any) {
    check_branching_laws(monoid, any, [](const auto& x, const auto& y) { return x == y; });
}

template <Semiring S, class Any>
void check_semiring_laws(const S& semiring, Any any) {
    check_monoid_laws(semiring, any);
    const auto times = [&](auto left, const auto& right) {
        semiring.append(left, right);
        return left;
    };
    const auto plus = [&](auto left, const auto& right) {
        semiring.add(left, right);
        return left;
    };
    for (int i = 0; i < 1000; ++i) {
        const auto x = any(), y = any(), z = any();
        REQUIRE(plus(plus(x, y), z) == plus(x, plus(y, z)));
        REQUIRE(plus(x, y) == plus(y, x));
        REQUIRE(plus(semiring.zero(), x) == x);
        REQUIRE(times(semiring.zero(), x) == semiring.zero());
        REQUIRE(times(x, semiring.zero()) == semiring.zero());
        REQUIRE(times(x, plus(y, z)) == plus(times(x, y), times(x, z)));
        REQUIRE(times(plus(x, y), z) == plus(times(x, z), times(y, z)));
    }
}

}  // namespace algae::laws
