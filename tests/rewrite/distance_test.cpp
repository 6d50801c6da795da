#include <doctest/doctest.h>
#include <rapidcheck.h>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "oracle/boxes.hpp"
#include "rewrite/derived_boxes.hpp"
#include "rewrite/detail/shapes.hpp"

using namespace algae;

namespace {

/// What a place 0.3 wide becomes with a wall at this distance.
std::string place_before_wall(const std::string& distance) {
    return boxes("alphabet wall place window\naxiom place(0,0,0, 0.3,1,1) wall(0.3+" + distance +
                     ",0,0, 1,1,1)\nplace(x,y,z) : distance(X, wall) > x -> I(window)",
                 1);
}

}  // namespace

TEST_CASE("a window only where the wall is further away than the place is wide") {
    CHECK(place_before_wall("0.2") == "place 0 0 0 0.3 1 1\nwall 0.5 0 0 1 1 1\n");
    CHECK(place_before_wall("0.3") == "place 0 0 0 0.3 1 1\nwall 0.6 0 0 1 1 1\n");
    CHECK(place_before_wall("0.4") == "window 0 0 0 0.3 1 1\nwall 0.7 0 0 1 1 1\n");
}

TEST_CASE("distances are measured in the word that is rewritten") {
    // In the first step the wall still stands, in the second it does not.
    CHECK(boxes("axiom AW\nW -> I(V)\nA(x,y,z) : distance(Y, W) = 0 -> I(B)\n"
                "B(x,y,z) : distance(Y, W) > 1e300 -> I(C)",
                2) == "C 0 0 0 1 1 1\nV 0 0 0 1 1 1\n");
}

TEST_CASE("a box is not the nearest to itself, and what is not there is infinitely far") {
    const std::string rule = "\nA(x,y,z) : distance(Z, A) > 5 -> I(B)";
    CHECK(boxes("axiom A" + rule, 1) == "B 0 0 0 1 1 1\n");
    CHECK(boxes("axiom A A(0,0,6, 1,1,1)" + rule, 1) == "A 0 0 0 1 1 1\nA 0 0 6 1 1 1\n");
    CHECK(boxes("axiom A A(0,0,6.5, 1,1,1)" + rule, 1) == "B 0 0 0 1 1 1\nB 0 0 6.5 1 1 1\n");
    CHECK(boxes("axiom A\nA(x,y,z) : min(distance(X,C), 7) = 7 -> I(B)\nC -> I(C)", 1) ==
          "B 0 0 0 1 1 1\n");
    CHECK(boxes("axiom A\nA(x,y,z) : distance(X,C) -> I(B)\nC -> I(C)", 1) == "B 0 0 0 1 1 1\n");
}

TEST_CASE("what is wrong with a distance is said where it stands") {
    const std::string axiom = "alphabet wall\naxiom A wall\n";
    CHECK(box_refusal(axiom + "A(x,y,z) : distance(x, wall) > x -> I(B)")
              .starts_with("test.lsys:3:21: error: expected an axis, X, Y or Z, found 'x'"));
    CHECK(box_refusal(axiom + "A(x,y,z) : distance(X, 3) > x -> I(B)")
              .starts_with("test.lsys:3:24: error: expected a symbol, found '3'"));
    CHECK(box_refusal(axiom + "A(x,y,z) : distance(X, wal) > x -> I(B)")
              .starts_with("test.lsys:3:24: error: expected a symbol of the system, found 'wal'; "
                           "did you mean 'wall'?"));
    CHECK(box_refusal(axiom + "A(x,y,z) : distance(X) > x -> I(B)")
              .starts_with("test.lsys:3:22: error: expected 2 arguments of distance, found 1"));
    const std::string elsewhere =
        "expected no distance but in the condition of a shape rule, found 'distance(X,wall)'";
    CHECK(box_refusal(axiom + "A(x,y,z) : distance(X, wall) > x -> B")
              .starts_with("test.lsys:3:12: error: " + elsewhere));
    CHECK(box_refusal(axiom + "A(x,y,z) -> div(X, distance(X, wall)){ B }")
              .starts_with("test.lsys:3:20: error: " + elsewhere));
    CHECK(box_refusal(axiom + "let c = distance(X, wall)\nA -> I(B)")
              .starts_with("test.lsys:3:9: error: " + elsewhere));
    CHECK(box_refusal("axiom A\nC -> I(C)\nA(x,y,z) : distance(X, C) - 1 > x -> I(B)") ==
          "test.lsys:3:12: the value of 'distance(X,C)-1' is too large, for the box A 0 0 0 1 1 1");
}

TEST_CASE("distances are printed as they are read") {
    const std::string text =
        "alphabet wall\naxiom A wall\nA(x,y,z) : distance(X,wall) > x & distance(Y,A) < 2 -> "
        "I(B)\n";
    CHECK(print_lsystem(read_lsystem(text, "")) == text);
}

TEST_CASE("the nearest box is the nearest of all that are looked at one by one") {
    CHECK(rc::check([] {
        const char letters[] = {'A', 'B'};
        std::vector<oracle::CutBox> all;
        std::string axiom = "axiom";
        for (int left = *rc::gen::inRange(1, 9); left > 0; --left) {
            oracle::CutBox box;
            box.letter = letters[*rc::gen::inRange(0, 2)];
            std::string origin, size;
            for (std::size_t i = 0; i < 3; ++i) {
                box.low[i] = *rc::gen::inRange(-9, 10);
                const int length = *rc::gen::inRange(1, 6);
                box.high[i] = box.low[i] + length;
                origin += std::to_string(static_cast<int>(box.low[i])) + ',';
                size += (i ? "," : "") + std::to_string(length);
            }
            axiom += std::string(" ") + box.letter + '(' + origin + size + ')';
            all.push_back(box);
        }
        const std::size_t axis = *rc::gen::inRange<std::size_t>(0, 3);
        const char symbol = *rc::gen::element('A', 'B');
        const int bound = *rc::gen::inRange(0, 12);
        const std::string condition = std::string("distance(") + axis_name(axis) + ", " + symbol +
                                      ") > " + std::to_string(bound);
        const std::string text = axiom + "\nA(x,y,z) : " + condition +
                                 " -> I(C)\nB(x,y,z) : " + condition + " -> I(C)\n";
        RC_LOG() << text;
        std::string expected;
        for (std::size_t i = 0; i < all.size(); ++i)
            expected += oracle::further_than(all, i, axis, symbol, bound) ? 'C' : all[i].letter;
        const View<ShapeSystem> shapes = as_shape(read_lsystem(text, "test.lsys"));
        std::string found;
        for (const ShapeBox& box : boxes_after(*shapes, shapes->axiom, 1))
            found += shapes->system->alphabet.name(box.symbol);
        RC_ASSERT(found == expected);
    }));
}

TEST_CASE("many boxes are no trouble") {
    std::string axiom = "axiom";
    for (int i = 0; i < 4000; ++i) axiom += " A(" + std::to_string(3 * i) + ",0,0, 1,1,1)";
    CHECK(boxes(axiom + "\nA(x,y,z) : distance(X, A) > 2 -> I(B)", 1).find('B') ==
          std::string::npos);
}
