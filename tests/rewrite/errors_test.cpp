#include <doctest/doctest.h>

#include "model/model.hpp"

#include "rewrite/words.hpp"

using namespace algae;

TEST_CASE("what has no value names the rule, the module, its position and the generation") {
    CHECK(refusal("axiom A(2)\nA(x) -> FA(x-1)B(1/x)", 5) ==
          "test.lsys:2:1: the rule for A(0) at position 2 of generation 2: division by 0 in '1/x'");
    CHECK(refusal("axiom A(-1)\nA(x) -> A(sqrt(x))", 1) ==
          "test.lsys:2:1: the rule for A(-1) at position 0 of generation 0: the square root of a "
          "negative number in 'sqrt(x)'");
    CHECK(refusal("axiom A(0)\nA(x) : log(x) > 1 -> A(1)", 1)
              .find("the logarithm of a number that is not positive in 'log(x)'") !=
          std::string::npos);
    CHECK(refusal("axiom A(-2)\nA(x) -> A(x^0.5)", 1)
              .find("a power of a negative number that is not whole") != std::string::npos);
    CHECK(refusal("axiom A(0)\nA(x) -> A(x^-1)", 1).find("a negative power of 0") !=
          std::string::npos);
    CHECK(refusal("axiom A(90)\nA(x) -> A(tan(x))", 1).find("'tan(x)' has no value") !=
          std::string::npos);
    CHECK(refusal("axiom A(2)\nA(x) -> A(asin(x))", 1)
              .find("'asin(x)' needs a number from -1 to 1") != std::string::npos);
    CHECK(refusal("axiom A(10)\nA(x) -> A(x^x)", 9).find("the value of 'x^x' is too large") !=
          std::string::npos);
    CHECK(
        refusal("axiom A(1e300)\nA(x) -> B(1/(x*x))", 9).find("the value of 'x*x' is too large") !=
        std::string::npos);
}

TEST_CASE("the same errors with contexts") {
    CHECK(refusal("axiom BA(0)\nB < A(x) -> C(1/x)", 1) ==
          "test.lsys:2:1: the rule for A(0) at position 1 of generation 0: division by 0 in '1/x'");
    CHECK(refusal("axiom BA(0)\nB < A(x) : 1/x > 0 -> C", 1) ==
          "test.lsys:2:1: the rule for A(0) at position 1 of generation 0: division by 0 in '1/x'");
    CHECK(refusal("axiom B[A]\n[ ->\nB < A -> A", 2) ==
          "the word of generation 1: the ']' at position 2 closes nothing");
}

TEST_CASE("a condition that is decided by its left side does not need the right one") {
    CHECK(word_of("axiom A(0)A(2); A(x) : x != 0 & 1/x < 1 -> B", 1) == "A(0)B");
    CHECK(word_of("axiom A(0)A(2); A(x) : x = 0 | 1/x < 0 -> B", 1) == "BA(2)");
}

TEST_CASE("two rules for the same module are an error at that module") {
    CHECK(refusal("axiom FA(4)\nA(x) : x < 9 -> A(x+1)\nA(x) : x > 4 -> B", 3) ==
          "test.lsys:2:1: the rule for A(5) at position 1 of generation 1: the rule at "
          "test.lsys:3:1 matches too, and not "
          "both have probabilities");
    CHECK(refusal("axiom A(1)\nA(x) -> B\nA(y) -> C", 1) ==
          "test.lsys:2:1: the rule for A(1) at position 0 of generation 0: the rule at "
          "test.lsys:3:1 matches too, and "
          "neither has a probability");
    CHECK(refusal("axiom BA\nB < A -> B\nB < A -> C", 1).find("test.lsys:3:1 matches too") !=
          std::string::npos);
    CHECK(word_of("axiom A(1); A(x) -> B(x); A(y) -> B(y)", 1) == "B(1)");  // the same rule twice
    CHECK(refusal("axiom A(1)\nA(x) : x > 0 -(1)-> B\nA(x) : x > -1 -(1)-> C", 1)
              .find("add up to more than 1") != std::string::npos);
}

TEST_CASE("rules that are none for words") {
    CHECK(refusal("axiom A\nA -> I(B)", 1) ==
          "test.lsys:2:1: the rule is a shape rule, which divides shapes and not words");
    CHECK(refusal("axiom A\nB[ < A -> C", 1).find("a left context without brackets") !=
          std::string::npos);
}

TEST_CASE(
    "a right context that leaves a branch it is not in is an error, where it once ended the "
    "program") {
    const std::string wanted =
        "test.lsys:2:1: expected a right context that is a tree, found a ']' that closes nothing";
    CHECK(refusal("axiom ABC[DE][SG[HI]M]\nBC < S > G]M -> X", 1) == wanted);
    CHECK(refusal("axiom A[B]\nA > [B]] -> X", 1) == wanted);
    CHECK(refusal("axiom A[B]\n[ > B] -> X", 1) == wanted);
    CHECK(refusal("axiom A[B]C\nA > [B]C -> X", 1) == "X[B]C");
    // Where brackets are ignored, such a rule matches nowhere.
    CHECK(refusal("ignore [ ]\naxiom A[B]\nA > B] -> X", 1) == "A[B]");
}

TEST_CASE("bounds") {
    const Rewriting rewriting(read_lsystem("axiom A(1); A(x) -> A(x)A(x)", "b.lsys"));
    Budget budget;
    budget.letters = 100;
    CHECK(derive(rewriting, 6, {}, budget).kinds.size() == 64);
    CHECK_THROWS_AS(derive(rewriting, 7, {}, budget), BoundReached);
    budget = {};
    budget.memory = 1000;
    CHECK_THROWS_AS(derive(rewriting, 12, {}, budget), BoundReached);
}
