#include <doctest/doctest.h>

#include <string>

#include "exact/exact.hpp"
#include "model/model.hpp"
#include "notation/notation.hpp"
#include "rewrite/rewrite.hpp"
#include "turtle/detail/module_turtle.hpp"
#include "turtle/turtle.hpp"

using namespace algae;

namespace {

class Strokes : public TurtleEvents {
public:
    void stroke(const Vector& from, const TurtleState& state) override {
        total += length(state.position - from);
    }
    double total = 0;
};

/// The length of all strokes of generation n, or what is said against it.
std::string drawn(const std::string& text, std::uint64_t n) {
    try {
        const Model system = read_lsystem(text, "walk.lsys");
        const Rewriting rewriting(system);
        Strokes strokes;
        ModuleTurtle(system, rewriting.rules().kinds, n).walk(derive(rewriting, n), strokes);
        return std::to_string(strokes.total);
    } catch (const Error& error) {
        return error.what();
    }
}

const std::string leaf = "system leaf { axiom F(1); F(x) -> F(2*x)[+F(x)] }\n";

}  // namespace

TEST_CASE("a turtle draws words that are spliced in and those of interpretations") {
    CHECK(drawn(leaf + "axiom A; A -> <leaf(1)>", 1) == "3.000000");
    CHECK(drawn(leaf + "axiom B(leaf(2))\ninterpret B(w) -> [<w>]<leaf(0)>", 0) == "10.000000");
    CHECK(drawn(leaf + "axiom B(\"F\")B(leaf(1))\ninterpret B(w) : length(w) > 1 -> <w>\n"
                       "interpret B(w) : length(w) = 1 -> F(10)",
                0) == "13.000000");
    CHECK(drawn("axiom B(\"C(\"F(3)\")\")\ninterpret B(w) -> <w>\ninterpret C(w) -> <w>", 0) ==
          "3.000000");
}

TEST_CASE("a turtle goes no way that is a word") {
    CHECK(drawn("axiom F(\"G\")", 0) ==
          "generation 0 of walk.lsys, position 0: F(\"G\"): expected a number for the turtle, "
          "found a "
          "word");
    CHECK(drawn("axiom +(\"G\")", 0).find("expected a number for the turtle") != std::string::npos);
    CHECK(drawn("axiom B(\"G\")\ninterpret B(w) : w > 1 -> F", 0) ==
          "generation 0 of walk.lsys, position 0, in the interpretation of B(\"G\"): B(\"G\"): "
          "expected "
          "numbers in 'w > 1', found a word");
    CHECK(drawn("axiom B(\"F(2)\",1)F(3)", 0) == "3.000000");
}
