#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "turtle/turtle_command.hpp"
#include "turtle/turtle_events.hpp"
#include "turtle/turtle_manner.hpp"

namespace algae {

/// Why a turtle does not obey.
struct TurtleRefusal {
    std::string reason;
    bool is_unmatched = false;  // a bracket or brace that closes nothing
};

/// A turtle that obeys commands one after another, and tells of what it does.
class Turtle {
public:
    /// Both must outlive the turtle.
    Turtle(const TurtleManner& manner, TurtleEvents& events)
        : manner_(manner),
          events_(events),
          state_(manner.start),
          default_turn_(turn_by(manner.angle)) {}

    const TurtleState& state() const { return state_; }

    /// Does what the command says with these parameters. Throws TurtleRefusal if it makes no sense here.
    void obey(const TurtleCommand& command, const double* values);
    /// Whether the command is in a part of the branch that `%` cut off.
    bool skips(const TurtleCommand& command) const {
        return cut_ && command.operation != TurtleOperation::push &&
               command.operation != TurtleOperation::pop;
    }
    /// Throws TurtleRefusal if a branch or a polygon is still open.
    void finish() const;

private:
    struct Saved {
        TurtleState state;
        std::size_t polygons;
    };

    Turn turn(const TurtleCommand& command, const double* values, bool mirrored);
    Turn yaw(const TurtleCommand& command, const double* values, bool mirrored);
    Turn tilt(const TurtleCommand& command, const double* values, bool mirrored);
    void go_to(const Vector& to, bool drawn, bool marked);
    void go(bool drawn, bool marked, double steps);
    void rescale(double factor);
    void set_width(const TurtleCommand& command, const double* values);
    void set_colour(const TurtleCommand& command, const double* values);
    void set_paint(const double* values);
    void tell_colour();
    void leave_stamp(const TurtleCommand& command, double size);
    void do_solid(const TurtleCommand& command, const double* values);
    void leave_surface(const TurtleCommand& command, double size);
    void open_branch();
    void close_branch();
    void end_polygon();
    void restore(const TurtleState& state);

    const TurtleManner& manner_;
    TurtleEvents& events_;
    TurtleState state_;
    Turns turns_;
    Turn default_turn_;
    std::vector<Saved> saved_;
    std::vector<std::vector<Vector>> polygons_;  // open ones, the innermost last
    std::vector<Vector> corners_;                // of a surface's face
    bool cut_ = false;                           // up to the end of the branch
    std::size_t cut_depth_ = 0;                  // branches opened since
};

}  // namespace algae
