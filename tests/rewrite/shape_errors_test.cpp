#include <doctest/doctest.h>

#include "rewrite/derived_boxes.hpp"

using namespace algae;

TEST_CASE("sizes that do not fit a box: place, expected, found, and the box") {
    CHECK(box_refusal("axiom A\nA -> div(X, 0.7, 0.5){ B C }") ==
          "test.lsys:2:13: expected sizes that add up to at most 1, found 1.2, along X, for the "
          "box A 0 0 0 1 1 1");
    CHECK(box_refusal("axiom A(1,4,1)\nA -> div(Y, 3, 1, 1r){ B C D }") ==
          "test.lsys:2:13: expected sizes that leave something of 4 for the relative ones, found "
          "4, along Y, for the "
          "box A 0 0 0 1 4 1");
    CHECK(box_refusal("axiom A(1,4,1)\nlet c = -1\nA -> div(Y, c, 1r){ B C }") ==
          "test.lsys:3:13: expected sizes above 0, found -1, along Y, for the box A 0 0 0 1 4 1");
    CHECK(box_refusal("axiom A\nA -> repeat(Z, 3){ B }") ==
          "test.lsys:2:16: expected a size of at most 1, found 3, along Z, for the box A 0 0 0 1 1 "
          "1");
    CHECK(box_refusal("axiom A\nA -> repeat(Z, 0){ B }") ==
          "test.lsys:2:16: expected a size above 0, found 0, along Z, for the box A 0 0 0 1 1 1");
    CHECK(box_refusal("axiom A\nA(x,y,z) -> div(X, 1/(x-1)){ B }") ==
          "test.lsys:2:23: division by 0 in '1/(x-1)', for the box A 0 0 0 1 1 1");
    CHECK(box_refusal("axiom A(1,0,1)\nA -> I(B)") ==
          "test.lsys:1:11: expected a size above 0 along Y, found 0");
}

TEST_CASE("rules that are none of boxes, each with its place") {
    CHECK(box_refusal("axiom A\nA -> I(B)\nB -> CC") ==
          "not a system of shape rules: the rule at test.lsys:3:1 makes a word, not div, repeat or "
          "I");
    CHECK(box_refusal("axiom A\nB < A -> I(B)") ==
          "not a system of shape rules: the rule at test.lsys:2:1 has a context");
    CHECK(box_refusal("axiom A\nA -(1/2)-> I(B)\nA -(1/2)-> I(C)") ==
          "not a system of shape rules: the rule at test.lsys:2:1 has a probability");
    CHECK(box_refusal("axiom A\nA(x) -> div(X, x, 1r){ B C }") ==
          "not a system of shape rules: the rule at test.lsys:2:1 has 1 parameter, and a box has "
          "three, its sizes "
          "along X, Y and Z");
    CHECK(box_refusal("axiom A\nA -> div(X, 1r, 1r){ B }") ==
          "not a system of shape rules: the rule at test.lsys:2:1 has 1 part for the 2 places that "
          "its sizes make");
    CHECK(box_refusal("axiom A\nA -> div(XZ, 1r, 1r : 1r){ B C D }") ==
          "not a system of shape rules: the rule at test.lsys:2:1 has 3 parts for the 2 places "
          "that its sizes make");
    CHECK(box_refusal("axiom A\nA -> repeat(X, 1r){ B }") ==
          "not a system of shape rules: the rule at test.lsys:2:1 has a relative size, and repeat "
          "takes a length");
    CHECK(box_refusal("axiom A(1)\nA -> I(B)") ==
          "not a system of shape rules: the axiom's 'A' has 1 argument, and a box has three, its "
          "sizes, or six, its "
          "origin and its sizes");
}

TEST_CASE("two rules for one box") {
    CHECK(box_refusal("axiom A\nA(x,y,z) : x > 0 -> I(B)\nA -> I(C)") ==
          "test.lsys:3:1: expected one rule for the box A 0 0 0 1 1 1, found that the rule at "
          "test.lsys:2:1 applies too");
    CHECK(box_refusal("axiom A\nA -> I(B)\nA -> I(B)") == "B 0 0 0 1 1 1\n");
}

TEST_CASE("too many boxes are refused before they are made") {
    CHECK_THROWS_WITH_AS(boxes("axiom A(1000000000000,1,1)\nA -> repeat(X, 1){ B }", 1),
                         "a step makes at least 1000000000000 boxes, more than the 1000000000 "
                         "allowed",
                         BoundReached);
}
