// What symbols leave in space: solids, surfaces, boxes of shape rules.

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/detail/module_turtle.hpp"
#include "turtle/detail/scene.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

Scene drawn(const std::string& text, std::uint64_t n = 0) {
    return scene(read_lsystem(text, ""), n, {}).scene;
}

/// By Newell's method, the area of a flat polygon.
double area(std::span<const Vector> corners) {
    Vector sum;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum = sum + cross(corners[i], corners[(i + 1) % corners.size()]);
    return length(sum) / 2;
}

}  // namespace

TEST_CASE("parameters of solids are the measures that the file names") {
    const auto only = [](const std::string& text) {
        const Scene scene = drawn(text);
        REQUIRE(scene.solids.size() == 1);
        return scene.solids.front();
    };
    CHECK(only("axiom B(3,2); solid B box height width").size == Vector{2, 3, 1});
    CHECK(only("axiom B(3,2); solid B cylinder height radius; step 2").size == Vector{6, 4, 0});
    CHECK(only("axiom B(3,2); solid B _typeCone _bottomRadius _height").size == Vector{2, 3, 0});
    CHECK(only("axiom B(3); solid B sphere radius").size == Vector{3, 0, 0});
    CHECK(only("axiom B; solid B sphere radius; shrink 1/2").size == Vector{1, 0, 0});
    CHECK(only("axiom B(7); solid B box").size == Vector{1, 1, 1});
    const Solid painted = only("axiom '(2)B(1,5); solid B sphere radius colour");
    CHECK(painted.paint == Paint{5, {}});
    CHECK(only("axiom '(2)B(1); solid B sphere radius colour").paint == Paint{2, {}});
    // The colour is that of the one solid only.
    const Scene next = drawn("axiom '(0,0,1)B(5)F; solid B sphere colour");
    CHECK(next.solids.front().paint == Paint{5, {}});
    CHECK(next.rods.front().paint.colour == Colour{0, 0, 1});
}

TEST_CASE("rotations and translations move the turtle in its own frame") {
    const char* settings = "; solid R rotation x y z; solid T translation x y z";
    const auto end = [&](const std::string& word) {
        return scene(read_lsystem("axiom " + word + settings, ""), 0, {}).end.position;
    };
    CHECK(end("R(0,0,90)F") == Vector{0, 1, 0});
    CHECK(end("R(0,90)F") == Vector{0, 0, -1});
    CHECK(end("R(90)T(0,1)") == Vector{0, 0, 1});
    CHECK(end("R(90,0,90)F") == Vector{0, 0, 1});
    CHECK(end("+(90)T(1,2,3)") == Vector{-2, 1, 3});
    CHECK(end("T") == Vector{});
}

TEST_CASE("surfaces lie where the turtle stands, as large as it says") {
    const Scene leaf = drawn("axiom f^(90)~K(2); surface K leaf");
    REQUIRE(leaf.faces.size() == 1);
    double highest = 0, widest = 0;
    for (const Vector& corner : leaf.corners_of(leaf.faces.front())) {
        CHECK(corner.x == 1);
        highest = std::max(highest, corner.z);
        widest = std::max(widest, corner.y);
    }
    CHECK(highest == doctest::Approx(2));
    CHECK(widest == doctest::Approx(0.4));  // half of 2/5, twice as large
    CHECK(area(drawn("axiom K; surface K disc").corners) ==
          doctest::Approx(std::numbers::pi / 4).epsilon(0.01));
    const Scene polygon = drawn("axiom +(90)K; surface K polygon (0,0,0) (1,0,0) (1,1,1)");
    CHECK(polygon.corners == std::vector<Vector>{{0, 0, 0}, {0, 1, 0}, {-1, 1, 1}});
    CHECK(leaves_plane(read_lsystem("axiom K; surface K polygon (0,0,0) (1,0,0) (1,1,1)", "")));
    CHECK_FALSE(leaves_plane(read_lsystem("axiom K; surface K petal", "")));
    const auto flat = figure(read_lsystem("axiom K; surface K petal", ""), 0, {});
    CHECK(flat->box().high.x == doctest::Approx(1));
    CHECK(flat->box().breadth() == doctest::Approx(1));
    CHECK(flat->box().height() == doctest::Approx(0.6).epsilon(0.01));
}

TEST_CASE("a patch over a flat square is the square, over a bent one goes through its corners") {
    std::string flat = "surface K patch", bent = flat;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) {
            const std::string at =
                " (" + std::to_string(row) + "/3," + std::to_string(column) + "/3,";
            flat += at + "0)";
            bent += at + (row == 1 && column == 1 ? "9/4)" : "0)");
        }
    const Scene square = drawn("axiom K; " + flat);
    double sum = 0;
    for (const Face& face : square.faces) sum += area(square.corners_of(face));
    CHECK(square.faces.size() == 72);
    CHECK(sum == doctest::Approx(1));
    // At the middle the weight of that point is (3/8)^2.
    const SpaceBox box = box_of(drawn("axiom K; " + bent));
    CHECK(box.low == Vector{0, 0, 0});
    CHECK(box.high.x == doctest::Approx(1));
    double middle = 0;
    const Scene hill = drawn("axiom K; " + bent);
    for (const Vector& corner : hill.corners)
        if (std::fabs(corner.x - 0.5) < 1e-9 && std::fabs(corner.y - 0.5) < 1e-9) middle = corner.z;
    CHECK(middle == doctest::Approx(2.25 * 9 / 64));
}

TEST_CASE("tropisms bend strokes, in the plane too") {
    // A heading across a tropism of length 1 is bent by the susceptibility in radians.
    const SpaceDerivation once =
        scene(read_lsystem("axiom FF; tropism 0 0 -1; susceptibility 0.2", ""), 0, {});
    CHECK(once.end.position.x == doctest::Approx(1 + std::cos(0.2)));
    CHECK(once.end.position.z == doctest::Approx(-std::sin(0.2)));
    const Model plane = read_lsystem("axiom FFF; tropism 0 1 0; susceptibility 0.5", "");
    CHECK_FALSE(leaves_plane(plane));
    CHECK(leaves_plane(read_lsystem("axiom FFF; tropism 0 1 1", "")));
    const double second = 0.5 + 0.5 * std::cos(0.5);  // |H x T| is the cosine of the angle so far
    CHECK(figure(plane, 0, {})->facts().end[1].value() ==
          doctest::Approx(std::sin(0.5) + std::sin(second)));
    // Against T nothing bends, and T beside H to the end.
    CHECK(scene(read_lsystem("axiom -FFF; tropism 0 1 0", ""), 0, {}).end.position ==
          Vector{0, -3, 0});
    // Before steps, moves too, and one radian at most.
    const Scene early = drawn("axiom fF; tropism 0 1 0 before; susceptibility 0.5");
    CHECK(early.rods[0].from.y == doctest::Approx(std::sin(0.5)));
    CHECK(early.rods[0].to.y == doctest::Approx(std::sin(0.5) + std::sin(second)));
    CHECK(drawn("axiom F; tropism 0 3 0 before").rods[0].to.y == doctest::Approx(std::sin(1.0)));
}

TEST_CASE("boxes of shape rules stand with Y up, each symbol with its colour") {
    const Model system =
        read_lsystem("axiom A(4,2,6); A -> div(Y, 1r, 1r){ B C }; colour red green blue", "");
    CHECK(leaves_plane(system));
    const SpaceDerivation found = scene(system, 1, {});
    REQUIRE(found.scene.solids.size() == 2);
    CHECK(found.facts.box.low == Vector{0, -6, 0});
    CHECK(found.facts.box.high == Vector{4, 0, 2});
    CHECK(found.scene.solids[1].middle == Vector{2, -3, 1.5});
    CHECK(found.scene.solids[1].size == Vector{4, 6, 1});
    CHECK(found.scene.solids[0].paint.index == *system.alphabet.find("B"));
    CHECK(found.scene.colours.size() == 3);
}

TEST_CASE("what cannot be drawn says where and why") {
    const auto refusal = [](const std::string& text, std::uint64_t n = 0) -> std::string {
        try {
            drawn(text, n);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    CHECK(refusal("axiom &A; interpret A -> F]").find("unmatched ']'") != std::string::npos);
    CHECK(refusal("axiom &A; A -> [F").find("'[' is never closed") != std::string::npos);
    CHECK(refusal("axiom &A; interpret A -> {F") == "generation 0: '{' is never closed");
    CHECK(refusal("axiom &F(1e308)F(1e308)") ==
          "generation 0, position 2: F(1e308): leads to a place that is not finite");
    CHECK(refusal("axiom &B(-1); solid B sphere radius") ==
          "generation 0, position 1: B(-1): expected measures of at least 0");
    CHECK(refusal("axiom &B(0.5); solid B sphere colour") ==
          "generation 0, position 1: B(0.5): expected the number of a colour, counted from 0");
    CHECK(refusal("axiom &K(-1); surface K disc") ==
          "generation 0, position 1: K(-1): expected a size of at least 0");
    CHECK(
        refusal("axiom ^(90)F@") ==
        "generation 0, position 2: @: the heading is vertical, so that there is no level direction "
        "to roll to");
}
