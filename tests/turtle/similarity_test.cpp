#include <doctest/doctest.h>

#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

Outline outlined(const std::string& text, std::uint64_t n) {
    return outline(read_lsystem(text, "test"), n);
}

Similarity compared(const std::string& left, const std::string& right, std::uint64_t n) {
    return similarity(outlined(left, n), "left", outlined(right, n), "right");
}

const std::string koch = "axiom F; F -> F+F--F+F; angle 60";

}  // namespace

TEST_CASE("an outline has the strokes and points that a trace counts") {
    for (const char* text :
         {"axiom F; F -> F+F--F+F; angle 60", "axiom F; F -> F[+F]F[-F]F; angle 30",
          "axiom F-F; F -> FF-F; angle 90; stamp S square", "axiom F(1); F(x) -> F(x/2)+(30)F(x)",
          "axiom F; F -> F+F; angle 25.7"}) {
        const Model system = read_lsystem(text, "test");
        for (std::uint64_t n = 0; n < 4; ++n) {
            const Outline found = outline(system, n);
            const Trace counted = trace(*figure(system, n, {}), {});
            CAPTURE(text);
            CHECK(found.strokes.size() == counted.distinct_segments);
            CHECK(found.points.size() == counted.vertices);
        }
    }
}

TEST_CASE(
    "figures are similar under motions, mirror images and changes of size, and that is proved "
    "where angles are exact") {
    const Similarity turned =
        compared(koch, "axiom F; F -> F+F--F+F; angle 60; start 3 4 50; step 7", 3);
    CHECK(turned.similar);
    CHECK(!turned.same_size);
    CHECK(turned.exact);
    const Similarity moved = compared(koch, "axiom F; F -> F+F--F+F; angle 60; start 3 4 90", 3);
    CHECK(moved.similar);
    CHECK(moved.same_size);
    CHECK(!moved.same_place);
    CHECK(compared(koch, "axiom F; F -> F-F++F-F; angle 60", 3).similar);
    const Similarity same = compared(koch, "axiom X; X -> X+X--X+X; interpret X -> F; angle 60", 3);
    CHECK(same.same_place);
    CHECK(same.exact);
}

TEST_CASE("figures that are not similar say what differs") {
    CHECK(compared(koch, "axiom F; F -> F+F-F-F+F", 2).difference ==
          "The figure of left has 16 different strokes, that of right has 25 different strokes.");
    const Similarity bent = compared(koch, "axiom F; F -> F+F--F+F; angle 45", 2);
    CHECK(!bent.similar);
    CHECK(bent.difference.find("no motion") != std::string::npos);
}

TEST_CASE("figures without exact places are compared as far as doubles go") {
    const std::string spiral = "axiom Fx; x -> -*Fx; angle 92; scale 0.98";
    const Similarity found = compared(spiral, spiral + "; start 1 2 30; step 3", 20);
    CHECK(found.similar);
    CHECK(!found.exact);
    CHECK(!compared(spiral, "axiom Fx; x -> -*Fx; angle 92; scale 0.97", 20).similar);
    CHECK(!compared("axiom SfS; stamp S square", "axiom SfS; stamp S circle", 0).similar);
}

TEST_CASE("figures whose points doubles do not tell apart are not called different") {
    const std::string square =
        "axiom F-F-F-F; F -> F-F+F+FF-F-F+F; angle 90; start -8 8 0; step 16";
    CHECK_THROWS_WITH_AS(compared(square, square + "; shrink 1/4999999999999999999999", 3),
                         "points of the figure lie too close together to be compared",
                         BoundReached);
    CHECK_THROWS_AS(compared(square + "; shrink 1/4999999999999999999999", square, 3),
                    BoundReached);
    CHECK(compared(square, square + "; shrink 1/4", 3).similar);
    // One point has no size, and is not far from itself.
    CHECK(compared("axiom S; stamp S square", "axiom S; stamp S square; start 3 4 0", 0).similar);
}

TEST_CASE("points more than 2^63 cells of the grid from the origin are told apart") {
    const Model system = read_lsystem(
        "axiom F(10000000,0)F(20000000,0)F(0,5); plot F; start 0 0 0; step 1e-9", "test");
    const Trace found = trace(*figure(system, 0, {}), {});
    CHECK(found.vertices == 4);
    CHECK(found.distinct_segments == 3);
}
