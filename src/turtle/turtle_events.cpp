#include "turtle/turtle_events.hpp"

#include <cmath>
#include <numbers>

namespace algae {

void TurtleEvents::stamp(StampShape shape, double size, const TurtleState& state) {
    polygon(stamp_corners(shape, size, state));
}

std::vector<Vector> stamp_corners(StampShape shape, double size, const TurtleState& state) {
    constexpr int round = 64;
    const int corners = shape == StampShape::square ? 4 : shape == StampShape::triangle ? 3 : round;
    const double first = shape == StampShape::square ? 45 : 0;
    const double radius = shape == StampShape::square     ? size * (std::numbers::sqrt2 / 2)
                          : shape == StampShape::triangle ? size / std::numbers::sqrt3
                                                          : size / 2;
    std::vector<Vector> out;
    for (int i = 0; i < corners; ++i) {
        const Turn turn = turn_by(first + 360.0 * i / corners);
        double ahead = radius * turn.cosine, aside = radius * turn.sine;
        if (shape == StampShape::square) {
            ahead = std::copysign(size / 2, ahead);
            aside = std::copysign(size / 2, aside);
        }
        out.push_back(state.position + ahead * state.attitude.heading() +
                      aside * state.attitude.left());
    }
    return out;
}

}  // namespace algae
