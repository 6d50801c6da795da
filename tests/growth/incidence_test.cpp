#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <map>

#include "exact/exact.hpp"
#include "growth/growth.hpp"

using namespace algae;

namespace {

/// Counts letter by letter, with no matrix and no fold.
Integer counted(const D0L& system, std::uint64_t n) {
    std::map<Symbol, Integer> counts;
    for (const Symbol a : system.axiom) counts[a] += 1;
    for (; n > 0; --n) {
        std::map<Symbol, Integer> next;
        for (const auto& [a, times] : counts)
            for (const Symbol b : system.successor(a)) next[b] += times;
        counts = std::move(next);
    }
    Integer sum = 0;
    for (const auto& [a, times] : counts) sum += times;
    return sum;
}

D0L any_system() {
    const auto word = rc::gen::container<std::string>(rc::gen::elementOf(std::string("abcd")));
    std::vector<std::pair<char, std::string>> rules;
    for (const char a : std::string("abcd")) rules.emplace_back(a, *rc::gen::resize(5, word));
    return d0l(*rc::gen::nonEmpty(rc::gen::resize(5, word)), rules);
}

}  // namespace

TEST_CASE("lengths by squaring and by iterating are the lengths counted letter by letter") {
    CHECK(rc::check([] {
        const D0L system = any_system();
        const auto n = *rc::gen::inRange<std::uint64_t>(0, 400);
        RC_ASSERT(length(system, n) == counted(system, n));
    }));
}

TEST_CASE("the estimate is close to the logarithm of the length") {
    CHECK(rc::check([] {
        const D0L system = any_system();
        const auto n = *rc::gen::inRange<std::uint64_t>(0, 400);
        const Integer exact = counted(system, n);
        const double estimate = estimated_log2_length(system, n);
        if (exact.is_zero())
            RC_ASSERT(std::isinf(estimate) && estimate < 0);
        else
            RC_ASSERT(std::abs(estimate - static_cast<double>(bit_length(exact))) <= 1.0 + 1e-6);
    }));
}

TEST_CASE("a length too long to write is refused at once, with about how many digits it has") {
    const D0L koch = d0l("F", {{'F', "F+F--F+F"}});
    CHECK_THROWS_WITH_AS(length(koch, 9'000'000'000'000),
                         "the length of generation 9000000000000 alone has about 5418539921952 "
                         "digits, more than the "
                         "1000000000 allowed",
                         BoundReached);
}

TEST_CASE("a generation far out of a system that grows slowly is exact") {
    const D0L system = d0l("b", {{'b', "aba"}});
    CHECK(length(system, 1'000'000'000'000) == Integer(2'000'000'000'001));
    CHECK(length(d0l("a", {{'a', ""}}), 1'000'000) == 0);
}
