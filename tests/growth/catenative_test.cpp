#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "growth/expanded.hpp"
#include "growth/growth.hpp"

using namespace algae;

TEST_CASE("the Fibonacci words are catenated from the two before") {
    const auto answer = locally_catenative(d0l("a", {{'a', "ab"}, {'b', "a"}}), 5);
    REQUIRE(answer.formula);
    CHECK(answer.formula->back == std::vector<std::size_t>{1, 2});
    CHECK(answer.formula->from == 2);
    CHECK(answer.formula->text() == "w(n) = w(n-1) w(n-2) for n >= 2");
    CHECK(answer.because == "it holds for n = 2, and the morphism maps each case to the next");
}

TEST_CASE("bounded and polynomial lengths have no formula at all") {
    const auto bounded = locally_catenative(d0l("a", {{'a', "b"}, {'b', "a"}}), 5);
    CHECK(bounded.kind == CatenativeAnswer::Kind::none);
    const auto polynomial = locally_catenative(d0l("a", {{'a', "ab"}, {'b', "b"}}), 5);
    CHECK(polynomial.kind == CatenativeAnswer::Kind::none);
    CHECK(polynomial.because ==
          "the lengths grow like a polynomial, and two words or more would make them grow "
          "exponentially");
    CHECK(locally_catenative(d0l("a", {{'a', "b"}, {'b', ""}}), 5).kind ==
          CatenativeAnswer::Kind::none);
}

TEST_CASE("what is not found is said not to be found") {
    const auto answer = locally_catenative(d0l("a", {{'a', "ab"}, {'b', "ba"}}), 3);
    CHECK(answer.kind == CatenativeAnswer::Kind::not_found);
    CHECK(answer.because.starts_with("no formula of depth up to 3 holds for any n up to "));
}

TEST_CASE("a formula holds for all later words") {
    CHECK(rc::check([] {
        const auto written = *rc::gen::oneOf(any_growing_d0l(), oracle::any_d0l());
        const auto answer = locally_catenative(oracle::d0l_of(written), 4);
        if (!answer.formula) return;
        const auto words = expanded(written, 50'000, 30);
        for (std::size_t n = answer.formula->from; n < words.size(); ++n) {
            std::string catenated;
            for (const std::size_t i : answer.formula->back) catenated += words.at(n - i);
            RC_ASSERT(words[n] == catenated);
        }
    }));
}
