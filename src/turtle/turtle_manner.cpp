#include "turtle/turtle_manner.hpp"

#include <cmath>

#include "base/error.hpp"

namespace algae {

namespace {

double value_or(const std::optional<Quantity>& setting, double otherwise) {
    return setting ? setting->value : otherwise;
}

}  // namespace

TurtleManner turtle_manner(const LSystem& system, std::uint64_t generation,
                           const std::string& name) {
    const Settings& settings = system.settings;
    TurtleManner manner;
    manner.angle = value_or(settings.angle, 90);
    manner.clockwise = settings.clockwise;
    if (manner.clockwise) manner.angle = -manner.angle;
    manner.scale = value_or(settings.scale, 1);
    manner.narrow = value_or(settings.narrow, 1);
    manner.susceptibility = value_or(settings.susceptibility, 1);
    if (const auto& to = settings.tropism)
        manner.tropism = Vector{to->x.value, to->y.value, to->z.value};
    TurtleState& start = manner.start;
    start.step = value_or(settings.step, 1) *
                 std::pow(value_or(settings.shrink, 1), static_cast<double>(generation));
    if (!std::isfinite(start.step) || start.step == 0)
        throw Error(name + ": the step of the turtle is " + std::to_string(start.step) +
                    ", expected a length that a drawing can have; see step and shrink");
    double heading = std::fmod(value_or(settings.spin, 0) * static_cast<double>(generation), 360.0);
    if (settings.start) {
        start.position = {settings.start->x.value, settings.start->y.value, 0};
        heading += settings.start->heading.value;
    }
    if (!std::isfinite(heading))
        throw Error(name + ": the heading of the start is no number; see start and spin");
    start.attitude.yaw(turn_by(heading));
    return manner;
}

}  // namespace algae
