#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "system/lsystem.hpp"
#include "turtle/pose.hpp"
#include "turtle/solid_module.hpp"

namespace algae {

/// What a turtle can be told to do.
enum class TurtleOperation : std::uint8_t {
    nothing,
    draw,
    draw_unmarked,
    move,
    left,
    right,
    down,
    up,
    roll_left,
    roll_right,
    back,
    level,
    push,
    pop,
    open_polygon,
    close_polygon,
    vertex,
    scale,
    width,
    colour,
    cut,
    plot,
    stamp,
    solid,
    surface
};

/// What the modules of a letter with so many parameters tell the turtle. The table is at
/// ModuleTurtle.
struct TurtleCommand {
    TurtleOperation operation = TurtleOperation::nothing;
    std::uint32_t parameters = 0;
    StampShape shape = StampShape::square;   // of a stamp
    std::optional<SolidModule> solid;        // of a solid
    std::vector<std::vector<Vector>> faces;  // of a surface
    bool leaves_plane = false;               // the figure is one in space where this is done

    /// How many of the parameters it looks at.
    std::uint32_t read() const;
};

/// The command of a letter with this number of parameters, in this system.
TurtleCommand turtle_command(const LSystem& system, Symbol letter, std::uint32_t parameters);

}  // namespace algae
