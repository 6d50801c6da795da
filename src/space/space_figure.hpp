#pragma once

#include <cstdint>
#include <memory>

#include "base/budget.hpp"
#include "environment/environment.hpp"
#include "rewrite/module_string.hpp"
#include "space/scene.hpp"
#include "system/lsystem.hpp"
#include "turtle/derived_modules.hpp"
#include "turtle/module_turtle.hpp"
#include "turtle/trace.hpp"

namespace algae {

/// What is known of a scene without looking at it.
struct SpaceFacts {
    std::uint64_t segments = 0;  // drawn, with multiplicity
    double length = 0;           // of all of them
    SpaceBox box;                // around what is drawn
    double step = 1;             // of the turtle at its start, or the shortest segment
};

/// A turtle's walk through space: what it left, and where it stopped.
struct SpaceDerivation {
    Scene scene;
    TurtleState end;
    SpaceFacts facts;
};

/// Whether figures of the system are scenes: some word of it, or its interpretation, may turn the
/// turtle out of the plane or asks for solids, surfaces that are not flat or plots of three
/// coordinates, or a tropism does, or its rules make boxes. The same for all generations. Linear in the size of the rules.
///
/// Example: leaves_plane(read_lsystem("axiom F+A; A -> &A", ""))
/// Example: !leaves_plane(read_lsystem("axiom F+A; A -> +A; B -> &", ""))
bool leaves_plane(const LSystem& system);

/// Generation `n` of a system in space, derived as open_modules says, walked as ModuleTurtle does; of
/// a system of shape rules its boxes (see box_scene).
///
/// Widths by `!(w)` are diameters: such rods have the radius w/2. Others are lines, as wide as their
/// multiple of the scene's line width. Of the rods that begin where one ends all but one are
/// branches: that is the one in the same brackets, or the first of those in the fewest.
///
/// Throws what open_modules, boxes_after and ModuleTurtle throw, and BoundReached if the scene takes more than
/// budget.memory. Linear in the length of the word.
///
/// Example: scene(read_lsystem("axiom F^(90)F(2)", ""), 0, {}).end.position == Vector{1, 0, 2}
SpaceDerivation scene(const LSystem& system, std::uint64_t n, const Budget& budget,
                      const FigureChoices& choices = {},
                      std::shared_ptr<Environment> external = nullptr);

/// The same for one word of modules over these kinds, drawn as generation `n` is. The seed is for
/// interpretations that have probabilities.
SpaceDerivation scene(const LSystem& system, const ModuleKinds& kinds, const ModuleString& word,
                      std::uint64_t n, std::uint64_t seed, const Budget& budget);

/// How many different segments and ends of them a scene has; see trace of a Figure.
Trace trace(const SpaceDerivation& derivation, const Budget& budget);

}  // namespace algae
