#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "growth/expanded.hpp"
#include "growth/growth.hpp"

using namespace algae;

namespace {

std::string class_of_words(const D0L& system) {
    const ComplexityOrder order = complexity_order(system);
    return order.is_decided() ? to_string(order.at_least)
                              : to_string(order.at_least) + " to " + to_string(order.at_most);
}

}  // namespace

TEST_CASE("each of the five classes occurs") {
    CHECK(class_of_words(d0l("a", {{'a', "ab"}, {'b', "b"}})) == "1");
    CHECK(class_of_words(d0l("a", {{'a', "ab"}, {'b', "ba"}})) == "n");
    CHECK(class_of_words(d0l("a", {{'a', "aba"}, {'b', "bb"}})) == "n log log n");
    CHECK(class_of_words(d0l("a", {{'a', "abc"}, {'b', "bb"}, {'c', "ccc"}})) == "n log n");
    CHECK(class_of_words(d0l("a", {{'a', "ab"}, {'b', "bc"}, {'c', "c"}})) == "n^2");
}

TEST_CASE("letters that do not grow make a word harder only if they are pushed") {
    CHECK(class_of_words(d0l("a", {{'a', "aaba"}, {'b', "b"}})) == "n");
    CHECK(class_of_words(d0l("a", {{'a', "acab"}, {'b', "bb"}, {'c', "c"}})) == "n log log n");
}

TEST_CASE("letters that vanish do not change the class") {
    CHECK(class_of_words(d0l("a", {{'a', "amb"}, {'b', "kba"}, {'m', ""}, {'k', "m"}})) == "n");
    CHECK(class_of_words(d0l("a", {{'a', "abab"}, {'b', ""}})) == "1");
}

TEST_CASE("periodic words in disguise") {
    CHECK(class_of_words(d0l("a", {{'a', "aa"}})) == "1");
    CHECK(class_of_words(d0l("a", {{'a', "aba"}, {'b', "bab"}})) == "1");
    CHECK(class_of_words(d0l("a", {{'a', "aba"}, {'b', "aba"}})) == "1");
    CHECK(class_of_words(d0l("a", {{'a', "abcbc"}, {'b', "bc"}, {'c', "bcbc"}})) == "1");
    CHECK(class_of_words(d0l("A", {{'A', "ABA"}, {'B', "BBB"}})) == "n");
}

TEST_CASE("languages whose words do not begin one another") {
    CHECK(class_of_words(d0l("c", {{'c', "acb"}})) == "n");
    CHECK(class_of_words(d0l("ba", {{'a', "aa"}, {'b', "bbb"}})) == "n");
    CHECK(class_of_words(d0l("F--F--F", {{'F', "F+F--F+F"}})) == "n");
    CHECK(class_of_words(d0l("X", {{'X', "F[+X][-X]FX"}, {'F', "FF"}})) == "n log n");
    CHECK(class_of_words(d0l("a", {{'a', "b"}, {'b', "a"}})) == "0");
}

TEST_CASE("what is not decided is bounded from both sides") {
    const ComplexityOrder order = complexity_order(
        d0l("cbad", {{'a', "aa"}, {'b', "bbb"}, {'d', "ddd"}, {'c', "ee"}, {'e', "c"}}));
    CHECK(!order.is_decided());
    CHECK(order.at_most == ComplexityClass::n_log_n);
}

TEST_CASE("the class agrees with the numbers of factors of random systems") {
    CHECK(rc::check([] {
        const auto written =
            *rc::gen::oneOf(any_growing_d0l(), any_growing_d0l(), oracle::any_d0l());
        const D0L system = oracle::d0l_of(written);
        const ComplexityOrder order = complexity_order(system);
        RC_ASSERT(!order.because.empty());
        RC_ASSERT(order.at_least <= order.at_most);
        const auto complexity = factor_complexity(system, 40);
        RC_CLASSIFY(order.is_decided(), "decided");
        RC_TAG(to_string(order.at_most));
        if (order.at_most == ComplexityClass::zero) {
            const auto words = expanded(written, 100'000, 40);
            std::size_t longest = 0;
            for (const std::string& word : words) longest = std::max(longest, word.size());
            RC_ASSERT(factor_complexity(system, longest + 1).back() == 0u);
            return;
        }
        // Morse and Hedlund: an unbounded number of factors is more than k for all k.
        if (order.at_least >= ComplexityClass::linear)
            for (std::size_t k = 0; k < complexity.size(); ++k) RC_ASSERT(complexity[k] > k);
        if (order.at_most == ComplexityClass::constant) {
            const auto more = factor_complexity(system, 160);
            RC_ASSERT(more[160] == more[159]);
        }
        if (order.at_least == ComplexityClass::quadratic)
            RC_ASSERT(factor_complexity(system, 144)[144] > 3 * complexity[40]);
    }));
}
