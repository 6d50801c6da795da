#include <doctest/doctest.h>

#include "rewrite/derived_boxes.hpp"
#include "rewrite/detail/shapes.hpp"

using namespace algae;

TEST_CASE("lengths and shares of what they leave") {
    CHECK(lengths_of(10, {{2}, {1, true}, {1, true}, {2}}) == std::vector<Rational>{2, 3, 3, 2});
    CHECK(lengths_of(1, {{1, true}, {2, true}}) ==
          std::vector<Rational>{Rational(1, 3), Rational(2, 3)});
    CHECK(lengths_of(1, {{Rational("0.3")}, {Rational("0.3")}}).size() == 2);
    CHECK_THROWS_WITH_AS(lengths_of(3, {{2}, {2}, {1, true}}),
                         "expected sizes that add up to at most 3, found 4", Error);
    CHECK_THROWS_WITH_AS(lengths_of(4, {{2}, {2}, {1, true}}),
                         "expected sizes that leave something of 4 for the relative ones, found 4",
                         Error);
    CHECK_THROWS_WITH_AS(lengths_of(4, {{2}, {0, true}}), "expected sizes above 0, found 0r",
                         Error);
}

TEST_CASE("as many parts as fit fill the box") {
    CHECK(parts_that_fit(Rational("1.8"), Rational("0.3")) == 6);
    CHECK(parts_that_fit(10, 3) == 3);
    CHECK(parts_that_fit(3, 3) == 1);
    CHECK(boxes("axiom B(10,1,1)\nB -> repeat(X, 3){ C }", 1) ==
          "C 0 0 0 10/3 1 1\nC 10/3 0 0 10/3 1 1\nC 20/3 0 0 10/3 1 1\n");
}

TEST_CASE("the documents' divisions") {
    CHECK(boxes("axiom A\nA -> div(Y, 0.1, 0.3, 0.3, 0.3){ B C C C }", 1) ==
          "B 0 0 0 1 0.1 1\nC 0 0.1 0 1 0.3 1\nC 0 0.4 0 1 0.3 1\nC 0 0.7 0 1 0.3 1\n");
    CHECK(boxes("axiom C(10,3,1)\nC -> div(X, 2, 1r, 1r, 2){ D E E D }", 1) ==
          "D 0 0 0 2 3 1\nE 2 0 0 3 3 1\nE 5 0 0 3 3 1\nD 8 0 0 2 3 1\n");
    // Three times 0.3 leaves a tenth of the wall empty.
    CHECK(boxes("axiom w\nw -> div(X, 0.3, 0.3, 0.3){ v v v }", 1) ==
          "v 0 0 0 0.3 1 1\nv 0.3 0 0 0.3 1 1\nv 0.6 0 0 0.3 1 1\n");
}

TEST_CASE("several axes, the last one named fastest") {
    CHECK(boxes("axiom A(2,1,6)\nA -> div(XZ, 1r, 1r : 1, 2, 3){ B C D E F G }", 1) ==
          "B 0 0 0 1 1 1\nC 0 0 1 1 1 2\nD 0 0 3 1 1 3\nE 1 0 0 1 1 1\nF 1 0 1 1 1 2\nG 1 0 3 1 1 "
          "3\n");
    CHECK(boxes("axiom A(2,2,2)\nA -> div(ZYX, 1 : 1, 1 : 1r){ B }", 1) ==
          "B 0 0 0 2 1 1\nB 0 1 0 2 1 1\n");
    CHECK(boxes("axiom A(1,1,1)\nA -> Split(X, 1r, 1r){ B C }", 1) ==
          "B 0 0 0 0.5 1 1\nC 0.5 0 0 0.5 1 1\n");
}

TEST_CASE("a box keeps its place when only its symbol changes, and stays without a rule") {
    CHECK(boxes("axiom A(1,2,3,4,5,6) B\nA -> I(C)", 3) == "C 1 2 3 4 5 6\nB 0 0 0 1 1 1\n");
}

TEST_CASE("sizes and conditions may use the sizes of the box and constants") {
    const std::string halves =
        "axiom A(8,1,1)\nlet least = 2\nA(x,y,z) : x > least -> div(X, x/2, 1r){ A A }\n"
        "A(x,y,z) : x <= least -> I(B)\n";
    CHECK(boxes(halves, 2) == "A 0 0 0 2 1 1\nA 2 0 0 2 1 1\nA 4 0 0 2 1 1\nA 6 0 0 2 1 1\n");
    CHECK(boxes(halves, 9) == "B 0 0 0 2 1 1\nB 2 0 0 2 1 1\nB 4 0 0 2 1 1\nB 6 0 0 2 1 1\n");
    CHECK(boxes("axiom A(2,2,2)\nA(x,y,z) -> div(X, sqrt(x), 1r){ B C }", 1) ==
          "B 0 0 0 1.4142135623730951 2 2\nC 1.4142135623730951 0 0 0.5857864376269049 2 2\n");
}

TEST_CASE("generations without end are no work once nothing changes") {
    CHECK(boxes("axiom A\nA -> I(B)", 1'000'000'000'000) == "B 0 0 0 1 1 1\n");
}
