// The start that lets plants stand.

#include <doctest/doctest.h>

#include <random>
#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

Vector end_of(const std::string& text) { return scene(read_lsystem(text, ""), 0, {}).end.position; }

}  // namespace

TEST_CASE("upward is the heading 90 in the plane") {
    const std::string rules = "axiom F; F -> F[+F]F[-F]F; angle 25; ";
    const auto box = [&](const std::string& start) {
        return open_figure(read_lsystem(rules + start, ""), 4, {})->box();
    };
    CHECK(box("start upward") == box("start 0 0 90"));
    CHECK(box("start upward; spin 30") == box("start 0 0 90; spin 30"));
}

TEST_CASE("upward is along z in space, and a heading of 90 is not") {
    CHECK(end_of("axiom F[&F]; start upward") == Vector{0, 0, 1});
    CHECK(end_of("axiom F[&F]; start 0 0 90") == Vector{0, 1, 0});
    CHECK(end_of("axiom [&F]+F; start upward") == Vector{-1, 0, 0});
    CHECK(end_of("axiom [&]&F; start upward") == Vector{0, 1, 0});
}

TEST_CASE("a word stands upward in space as it is drawn in the plane") {
    std::mt19937 random(7);
    int compared = 0;
    for (int round = 0; round < 300; ++round) {
        std::string word;
        for (int i = 0; i < 30; ++i) word += std::string("FF+-f|")[random() % 6];
        const std::string rest = "; angle 37; start upward; spin 11";
        const auto flat = open_figure(read_lsystem("axiom " + word + rest, ""), 0, {});
        const Vector stands = end_of("axiom " + word + "[&]" + rest);
        const auto& end = flat->facts().end;
        CHECK(stands.x == doctest::Approx(end[0].value()).epsilon(1e-9));
        CHECK(stands.z == doctest::Approx(end[1].value()).epsilon(1e-9));
        CHECK(std::abs(stands.y) < 1e-9);
        ++compared;
    }
    CHECK(compared == 300);
}

TEST_CASE("plants that lie are told from what does not") {
    const auto lies = [](const char* text) { return lies_down(read_lsystem(text, "")); };
    CHECK(lies("axiom F; F -> F[+F]F"));
    CHECK(!lies("axiom F; F -> F[+F]F; start upward"));
    CHECK(!lies("axiom F; F -> F[+F]F; start 0 0 0"));
    CHECK(!lies("axiom +F; F -> F[+F]F"));
    CHECK(!lies("axiom ^(90)F; F -> F[+F]F"));
    CHECK(!lies("axiom F; F -> F+F--F+F"));
    CHECK(!lies("axiom A; A -> [F]A"));  // no stem, as in a head of florets
}
