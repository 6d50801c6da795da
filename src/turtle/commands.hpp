#pragma once

#include <vector>

#include "system/d0l.hpp"
#include "system/lsystem.hpp"

namespace algae {

/// One thing a turtle in the plane does (Prusinkiewicz and Lindenmayer 1990, 1.3 and appendix).
enum class Command : unsigned char {
    draw,           // F, F_x: a step with the pen down
    draw_unmarked,  // G: the same, but no vertex of a polygon
    move,           // f, f_x: a step with the pen up
    left,           // +
    right,          // -
    back,           // |
    push,           // [
    pop,            // ]
    open_polygon,   // {
    close_polygon,  // }
    vertex,         // .
    scale,          // * where the file sets `scale`
    narrow,         // ! where the file sets `narrow`
    next_colour,    // '
    cut,            // %: the rest of the branch is left out
};

/// What each symbol makes the turtle do, after `interpret` rules, applied again and again until
/// only symbols without one are left. Symbols that mean nothing to a turtle have no commands.
class Commands {
public:
    /// Throws Error if a symbol asks for a turtle in space (& ^ \ / and so on) or leaves a surface, if the
    /// interpretation goes round in circles, or needs more than plain rules.
    explicit Commands(const LSystem& system, const std::vector<Symbol>& letters);

    const std::vector<Command>& of(Symbol a) const { return commands_[a]; }
    /// Whether any of the letters has this command.
    bool uses(Command command) const { return used_[static_cast<std::size_t>(command)]; }

private:
    std::vector<std::vector<Command>> commands_;
    bool used_[16] = {};
};

/// Throws the Error that says that this symbol makes a figure in space of the system's.
[[noreturn]] void refuse_space(const LSystem& system, Symbol symbol);

}  // namespace algae
