#pragma once

#include <cstddef>
#include <vector>

#include "turtle/module_turtle.hpp"

namespace algae {

/// A turtle seen now and then on its walk.
struct WatchedWalk {
    std::vector<TurtleState> states;  // after each of some numbers of symbols
    Vector low, high;                 // the box around all places where it comes to a symbol
};

/// Watches a turtle after these numbers of symbols, which rise; 0 is its start. Throws what walking
/// throws. Linear in the length of the word.
WatchedWalk watched_walk(const ModuleTurtle& turtle, const ModuleString& word,
                         const std::vector<std::size_t>& symbols, const Budget& budget = {});

/// A turtle's glyph: an arrowhead around the place, ahead of it and behind by half of `size`: its
/// tip, left corner, notch and right corner.
///
/// Example: turtle_glyph({}, 2).front() == Vector{1, 0, 0}
std::vector<Vector> turtle_glyph(const TurtleState& turtle, double size);

/// The colour of turtles that are drawn.
inline constexpr Colour turtle_green{0.13, 0.45, 0.25};

/// After how many symbols of a word each frame is that shows the turtle at work: 0, then every one or
/// every second and so on, so that there are at most `most` frames (at least 2), and all of them.
///
/// Example: frames_of_progress(3, 10) == std::vector<std::size_t>{0, 1, 2, 3}
/// Example: frames_of_progress(10, 5) == std::vector<std::size_t>{0, 3, 6, 9, 10}
std::vector<std::size_t> frames_of_progress(std::size_t symbols, std::size_t most);

}  // namespace algae
