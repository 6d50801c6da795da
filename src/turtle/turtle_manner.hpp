#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "system/lsystem.hpp"
#include "turtle/turtle_events.hpp"

namespace algae {

/// How a system wants its turtle to be: where it starts in a generation, and what commands without
/// parameters mean.
struct TurtleManner {
    TurtleState start;
    double angle = 90;       // degrees, negative where + turns right
    bool clockwise = false;  // + turns right
    double scale = 1, narrow = 1;
    std::optional<Vector> tropism;
    double susceptibility = 1;
};

/// The manner of a system in a generation; `name` is what messages call it. Throws Error if the step is
/// 0 or no number, or the heading no number.
TurtleManner turtle_manner(const LSystem& system, std::uint64_t generation,
                           const std::string& name);

}  // namespace algae
