#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/budget.hpp"
#include "rewrite/module_string.hpp"
#include "system/lsystem.hpp"
#include "turtle/module_turtle.hpp"

namespace algae {

/// A straight way of a turtle, with the pen down or up.
struct ExplainedLine {
    Vector from, to;
    bool drawn = false;
    TurtleState state;  // at its end
};

/// What one symbol of a word makes a turtle do.
struct ExplainedStep {
    std::string symbol;   // as it is printed: "F(2)"
    std::string meaning;  // in words: "forward 2, drawing"
    TurtleState before, after;
    std::size_t open = 0;                   // branches that are open afterwards
    std::optional<std::size_t> returns_to;  // the step that began the branch it ends, from 0
    std::vector<ExplainedLine> lines;
    std::vector<std::vector<Vector>> polygons;
};

/// A turtle's walk over a word, step by step.
struct Explanation {
    std::string name;  // "generation 1 of koch", as messages call it
    std::string word;
    TurtleState start;
    std::vector<ExplainedStep> steps;
};

/// A place or a length for people: rounded to 4 decimals, without zeros at the end.
///
/// Example: rounded(0.1 + 0.2) == "0.3"
/// Example: rounded(-1e-12) == "0"
std::string rounded(double value);

/// The heading in the plane as an angle, 0 along +x and counter-clockwise, from 0 to 360; nothing if
/// it leaves the plane.
///
/// Example: heading_angle(TurtleState{}) == 0.0
std::optional<double> heading_angle(const TurtleState& state);

/// What each symbol of a word does to the turtle, in words that are about what happened: a symbol
/// with an interpretation says all that comes of it. Linear in the length of the word.
///
/// Throws what ModuleTurtle throws.
Explanation explanation(const LSystem& system, const ModuleKinds& kinds, const ModuleString& word,
                        std::uint64_t generation, std::uint64_t seed, const Budget& budget = {});

}  // namespace algae
