#include "turtle/turtle.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "system/system.hpp"

using namespace algae;

namespace {

SpaceDerivation drawn(const std::string& text, std::uint64_t n = 0, const Budget& budget = {}) {
    return scene(read_lsystem(text, ""), n, budget);
}

std::vector<std::uint32_t> befores(const Scene& scene) {
    std::vector<std::uint32_t> out;
    for (const Rod& rod : scene.rods) out.push_back(rod.before);
    return out;
}

std::vector<bool> branches(const Scene& scene) {
    std::vector<bool> out;
    for (const Rod& rod : scene.rods) out.push_back(rod.branch);
    return out;
}

constexpr std::uint32_t none = Rod::none;

}  // namespace

TEST_CASE("rods know where they begin, and which one goes on") {
    const Scene stem = drawn("axiom F[+F][&F]F").scene;
    CHECK(befores(stem) == std::vector<std::uint32_t>{none, 0, 0, 0});
    CHECK(branches(stem) == std::vector<bool>{false, true, true, false});
    const Scene fork = drawn("axiom F[+FF][-F]").scene;
    CHECK(befores(fork) == std::vector<std::uint32_t>{none, 0, 1, 0});
    CHECK(branches(fork) == std::vector<bool>{false, false, false, true});
    const Scene nested = drawn("axiom F[[+F]-F]").scene;
    CHECK(branches(nested) == std::vector<bool>{false, true, false});
    const Scene apart = drawn("axiom FfF").scene;
    CHECK(befores(apart) == std::vector<std::uint32_t>{none, none});
}

TEST_CASE("widths that are lengths are diameters, others are lines") {
    const Scene rods = drawn("axiom F!F[!(0.5)F!F]F; narrow 1/2").scene;
    REQUIRE(rods.rods.size() == 5);
    CHECK(rods.rods[0].radius == 0);
    CHECK(rods.rods[0].line_width == 1);
    CHECK(rods.rods[1].line_width == 0.5);
    CHECK(rods.rods[2].radius == 0.25);
    CHECK(rods.rods[3].radius == 0.125);
    CHECK(rods.rods[4].radius == 0);
    CHECK(rods.rods[4].line_width == 0.5);
}

TEST_CASE("colours are those of the list, or their own") {
    const Scene scene = drawn("axiom F['(1,0.5,0)F]F'(3)F'F; colour red green").scene;
    REQUIRE(scene.rods.size() == 5);
    CHECK(scene.rods[0].paint == Paint{0, {}});
    CHECK(scene.rods[1].paint.colour == Colour{1, 0.5, 0});
    CHECK(scene.rods[2].paint == Paint{0, {}});
    CHECK(scene.rods[3].paint == Paint{3, {}});
    CHECK(scene.rods[4].paint == Paint{4, {}});
    CHECK(scene.colours == std::vector<std::string>{"red", "green"});
    CHECK_THROWS_WITH_AS(
        drawn("axiom '(1,2,0)F"),
        "generation 0, position 0: '(1,2,0): expected red, green and blue, each from 0 to 1",
        Error);
}

TEST_CASE("colours along the word are those of a circle of hues") {
    const Scene scene = drawn("axiom F&F|F'F; colour along red").scene;
    REQUIRE(scene.rods.size() == 4);
    CHECK(scene.rods[0].paint.colour == scheme_colour("along", 0));
    CHECK(scene.rods[1].paint.colour == scheme_colour("along", std::floor(256 * 2.0 / 7) / 256));
    CHECK(scene.rods[3].paint == Paint{1, {}});
}

TEST_CASE("a system leaves the plane if a symbol that it reaches does") {
    const auto leaves = [](const char* text) { return leaves_plane(read_lsystem(text, "")); };
    CHECK(leaves("axiom F&F"));
    CHECK(leaves("axiom A; A -> B; B -> \\F"));
    CHECK(leaves("axiom A; interpret A -> F^F"));
    CHECK_FALSE(leaves("axiom F+F|F"));
    CHECK_FALSE(leaves("axiom F; A -> &"));
}

TEST_CASE("a scene that takes more than the budget is refused") {
    Budget small;
    small.memory = 1 << 20;
    CHECK_THROWS_AS(drawn("axiom F; F -> F&F", 18, small), BoundReached);
}
