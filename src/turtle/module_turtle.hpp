#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/budget.hpp"
#include "rewrite/module_string.hpp"
#include "rewrite/rule_set.hpp"
#include "system/lsystem.hpp"
#include "turtle/turtle.hpp"

namespace algae {

/// "generation 5 of koch", as messages call it.
std::string figure_name(const LSystem& system, std::uint64_t generation);

/// A turtle for words of modules, in the plane and in space (Prusinkiewicz and Lindenmayer 1990,
/// 1.5 and 1.10.3; Hanan 1992). Positions are doubles.
///
/// It starts at the file's `start` with H along +x, L along +y and U along +z, turned about U by the
/// heading of the start and `spin` times the generation. The first parameter of a module says how
/// much; without one it is the step or the angle of the file. Further ones are not looked at.
///
/// - F, F_x, G draw and f, f_x move that many steps; the step is `step` times `shrink` to the power
///   of the generation. Negative amounts go backward.
/// - + and - turn left and right, & and ^ pitch down and up, \ and / roll left and right, by degrees;
///   | turns back; $ and @ roll until L is level.
/// - `*` multiplies the turtle's own step by `scale`, `*(k)` by k. `!` multiplies the width by `narrow`,
///   `!(w)` sets it to the length w. ' goes on to the next colour, '(k) to colour k,
///   '(r,g,b) to the colour with these parts, each from 0 to 1.
/// - [ ] { } . and % are those of the plane.
/// - A symbol of `plot` with two or three parameters draws a line to that point and stands there.
/// - A symbol of `stamp` leaves its shape, of the size of two steps, or of as many as it says.
/// - A symbol of `solid` leaves its solid, or turns or moves the turtle with the pen up; its parameters
///   are measures in steps and degrees (see SolidModule). A rotation is counter-clockwise, first
///   about the heading, then about the left and then about the up that come of it.
/// - A symbol of `surface` leaves it, once or as many times as large as it says; see surface_faces.
///
/// Where the file has a `tropism` T, the turtle is turned after each stroke by the angle e |H x T| in
/// radians about H x T, so that H goes towards T, e being the `susceptibility` (Prusinkiewicz and
/// Lindenmayer 1990, 2.3.4). T is not made a unit vector.
///
/// `interpret` rules are applied to each module, and to what they give, until none matches. Where
/// they have probabilities, the numbers are those of Draws for the seed with all bits turned round,
/// one for each choice on the way; so every walk over a word is the same.
class ModuleTurtle {
public:
    /// For words over these kinds. Throws Error if an interpretation rule has contexts, `Diagnostics` if
    /// constant expression has no value, and Error if the step is 0 or no number.
    ModuleTurtle(const LSystem& system, const ModuleKinds& kinds, std::uint64_t generation,
                 std::uint64_t seed = 1);

    /// Walks the word and says where it ends. Linear in the number of commands.
    ///
    /// Throws Error, with the generation, the module and its position, for brackets or braces that
    /// do not match, an amount that makes no sense, a position that is not finite, a heading that
    /// is vertical where it is to be levelled, and interpretations that never end; what
    /// budget.check throws.
    TurtleState walk(const ModuleString& word, TurtleEvents& events,
                     const Budget& budget = {}) const;

    /// The symbol by which the word, or an interpretation that it may use, leaves the plane: & ^ \ / $,
    /// a solid, a surface that is not flat or a plot of three coordinates. Nothing for a figure in the plane.
    std::optional<Symbol> symbol_of_space(const ModuleString& word) const;

    /// The turtle before the first module.
    const TurtleState& start() const { return manner_.start; }
    /// The figure_name.
    const std::string& name() const { return name_; }

private:
    class Walk;

    bool has_interpretation(ModuleKind kind) const;

    CompiledRules rules_;                  // the interpretation; its own numbers for kinds
    std::vector<ModuleKind> own_kinds_;    // by kind of the word
    std::vector<TurtleCommand> commands_;  // by own kind; where no interpretation matches
    std::vector<char> interpreted_;        // by own kind: some interpretation may match
    std::string name_;
    TurtleManner manner_;
    std::uint64_t generation_, seed_;
};

}  // namespace algae
