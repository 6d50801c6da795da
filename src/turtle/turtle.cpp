#include "turtle/turtle.hpp"

#include <algorithm>
#include <cmath>

namespace algae {

namespace {

double amount(const TurtleCommand& command, const double* values, double otherwise) {
    return command.parameters > 0 ? *values : otherwise;
}

std::uint32_t colour_number(double number) {
    constexpr double most = 4294967295;
    if (!(number >= 0 && number <= most && number == std::floor(number)))
        throw TurtleRefusal{"expected the number of a colour, counted from 0"};
    return static_cast<std::uint32_t>(number);
}

}  // namespace

/// The turn that a command asks for, the other way if `mirrored`.
Turn Turtle::turn(const TurtleCommand& command, const double* values, bool mirrored) {
    Turn turn = command.parameters > 0 ? turns_.by(*values) : default_turn_;
    if (mirrored) turn.sine = -turn.sine;
    return turn;
}

/// Turns about up go the other way round after `turn clockwise`, which the file's own angle has in it.
Turn Turtle::yaw(const TurtleCommand& command, const double* values, bool mirrored) {
    return turn(command, values, mirrored != (manner_.clockwise && command.parameters > 0));
}

/// Other turns do not, whether or not they have an amount.
Turn Turtle::tilt(const TurtleCommand& command, const double* values, bool mirrored) {
    return turn(command, values, mirrored != (manner_.clockwise && command.parameters == 0));
}

void Turtle::go_to(const Vector& to, bool drawn, bool marked) {
    if (!std::isfinite(to.x + to.y + to.z))
        throw TurtleRefusal{"leads to a place that is not finite"};
    const Vector from = state_.position;
    state_.position = to;
    if (drawn)
        events_.stroke(from, state_);
    else
        events_.move(from, state_);
    if (marked && !polygons_.empty()) polygons_.back().push_back(to);
}

void Turtle::go(bool drawn, bool marked, double steps) {
    const double way = state_.step * steps;
    go_to(state_.position + way * state_.attitude.heading(), drawn, marked);
    if (!drawn || !manner_.tropism) return;
    const Vector& to = *manner_.tropism;
    const double pull = length(cross(state_.attitude.heading(), to));
    state_.attitude.bend(to, manner_.susceptibility * pull);
}

void Turtle::rescale(double factor) {
    state_.step *= factor;
    if (!std::isfinite(state_.step)) throw TurtleRefusal{"makes the step longer than any number"};
}

void Turtle::set_width(const TurtleCommand& command, const double* values) {
    if (command.parameters > 0) {
        if (*values < 0) throw TurtleRefusal{"expected a width of at least 0"};
        state_.width = {*values, true};
    } else {
        state_.width.amount *= manner_.narrow;
    }
    events_.width(state_.width);
}

void Turtle::tell_colour() {
    if (state_.paint)
        events_.paint(*state_.paint);
    else
        events_.colour(state_.colour);
}

void Turtle::set_paint(const double* values) {
    if (std::any_of(values, values + 3, [](double part) { return !(part >= 0 && part <= 1); }))
        throw TurtleRefusal{"expected red, green and blue, each from 0 to 1"};
    state_.paint = Colour{values[0], values[1], values[2]};
    tell_colour();
}

void Turtle::set_colour(const TurtleCommand& command, const double* values) {
    if (command.parameters == 3) return set_paint(values);
    state_.colour = command.parameters > 0 ? colour_number(*values) : state_.colour + 1;
    state_.paint.reset();
    tell_colour();
}

void Turtle::leave_stamp(const TurtleCommand& command, double size) {
    if (size < 0) throw TurtleRefusal{"expected a size of at least 0"};
    events_.stamp(command.shape, size * std::fabs(state_.step), state_);
}

/// Turns or moves the turtle, or leaves a solid.
void Turtle::do_solid(const TurtleCommand& command, const double* values) {
    const SolidModule& module = *command.solid;
    Vector size = module.size(values, command.parameters);
    Attitude& look = state_.attitude;
    if (module.is_rotation()) {
        look.roll(turns_.by(-size.x));  // to the left is clockwise about the heading
        look.pitch(turns_.by(size.y));
        look.yaw(turns_.by(size.z));
        return;
    }
    size = std::fabs(state_.step) * size;
    const auto shape = module.shape();
    if (!shape)
        return go_to(
            state_.position + size.x * look.heading() + size.y * look.left() + size.z * look.up(),
            false, true);
    if (!std::isfinite(size.x + size.y + size.z) || std::min({size.x, size.y, size.z}) < 0)
        throw TurtleRefusal{"expected measures of at least 0"};
    if (const auto number = module.colour(values, command.parameters))
        events_.colour(colour_number(*number));
    events_.solid(*shape, size, state_);
    tell_colour();
}

void Turtle::leave_surface(const TurtleCommand& command, double size) {
    size *= std::fabs(state_.step);
    if (!(size >= 0 && std::isfinite(size))) throw TurtleRefusal{"expected a size of at least 0"};
    const Attitude& look = state_.attitude;
    for (const auto& face : command.faces) {
        corners_.clear();
        for (const Vector& at : face)
            corners_.push_back(state_.position + size * at.x * look.heading() +
                               size * at.y * look.left() + size * at.z * look.up());
        events_.polygon(corners_);
    }
}

void Turtle::open_branch() {
    if (cut_) {
        ++cut_depth_;
        return;
    }
    saved_.push_back({state_, polygons_.size()});
    events_.branched(state_);
}

void Turtle::close_branch() {
    if (cut_ && cut_depth_ > 0) {
        --cut_depth_;
        return;
    }
    if (saved_.empty()) throw TurtleRefusal{"unmatched ']'", true};
    if (cut_) polygons_.resize(std::min(polygons_.size(), saved_.back().polygons));
    cut_ = false;
    restore(saved_.back().state);
    saved_.pop_back();
}

void Turtle::restore(const TurtleState& state) {
    const bool wider = state.width != state_.width,
               other = state.colour != state_.colour || state.paint != state_.paint;
    state_ = state;
    if (wider) events_.width(state_.width);
    if (other) tell_colour();
    events_.returned(state_);
}

void Turtle::end_polygon() {
    if (polygons_.empty()) throw TurtleRefusal{"unmatched '}'", true};
    if (polygons_.back().size() > 2) events_.polygon(polygons_.back());
    polygons_.pop_back();
}

void Turtle::obey(const TurtleCommand& command, const double* values) {
    using enum TurtleOperation;
    if (skips(command)) return;
    switch (command.operation) {
        case nothing:
            break;
        case draw:
            go(true, true, amount(command, values, 1));
            break;
        case draw_unmarked:
            go(true, false, amount(command, values, 1));
            break;
        case move:
            go(false, true, amount(command, values, 1));
            break;
        case left:
            state_.attitude.yaw(yaw(command, values, false));
            break;
        case right:
            state_.attitude.yaw(yaw(command, values, true));
            break;
        case down:
            state_.attitude.pitch(tilt(command, values, false));
            break;
        case up:
            state_.attitude.pitch(tilt(command, values, true));
            break;
        case roll_left:
            state_.attitude.roll(tilt(command, values, false));
            break;
        case roll_right:
            state_.attitude.roll(tilt(command, values, true));
            break;
        case back:
            state_.attitude.turn_back();
            break;
        case level:
            if (!state_.attitude.level())
                throw TurtleRefusal{
                    "the heading is vertical, so that there is no level direction to roll to"};
            break;
        case push:
            open_branch();
            break;
        case pop:
            close_branch();
            break;
        case open_polygon:
            polygons_.push_back({state_.position});
            break;
        case close_polygon:
            end_polygon();
            break;
        case vertex:
            if (!polygons_.empty()) polygons_.back().push_back(state_.position);
            break;
        case scale:
            rescale(amount(command, values, manner_.scale));
            break;
        case width:
            set_width(command, values);
            break;
        case colour:
            set_colour(command, values);
            break;
        case cut:
            cut_ = true;
            cut_depth_ = 0;
            break;
        case plot:
            go_to({values[0], values[1], command.parameters > 2 ? values[2] : 0}, true, true);
            break;
        case stamp:
            leave_stamp(command, amount(command, values, 2));
            break;
        case solid:
            do_solid(command, values);
            break;
        case surface:
            leave_surface(command, amount(command, values, 1));
            break;
    }
}

void Turtle::finish() const {
    if (!polygons_.empty() && !cut_) throw TurtleRefusal{"'{' is never closed"};
    if (!saved_.empty()) throw TurtleRefusal{"'[' is never closed"};
}

}  // namespace algae
